// SPDX-License-Identifier: BSD-3-Clause
// Selection, picking and depth: queries to a drawn window.
#include "vtkIndirectContractUtilities.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkCallbackCommand.h"
#include "vtkCellPicker.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkPropPicker.h"
#include "vtkRenderWindow.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedIntArray.h"
#include "vtkWorldPointPicker.h"

#include <algorithm>
#include <set>

using namespace contract;

namespace
{
struct PickScene
{
  View Window{ 120, 100 };
  vtkNew<vtkIndirectIlluminationPass> Pass;

  explicit PickScene(bool withPass)
  {
    AddRoom(this->Window.Renderer);
    if (withPass)
    {
      this->Window.Renderer->SetPass(this->Pass);
    }
    this->Window.Window->Render();
  }
};

using Selected = std::set<std::pair<int, vtkIdType>>;

// Cells, or points, selected in a rectangle, by actor.
Selected Select(PickScene& scene, int association, const std::array<unsigned int, 4>& area)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Window.Renderer);
  selector->SetArea(area[0], area[1], area[2], area[3]);
  selector->SetFieldAssociation(association);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Selected result;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    vtkObjectBase* prop = node->GetProperties()->Get(vtkSelectionNode::PROP());
    const int index = scene.Window.Renderer->GetViewProps()->IsItemPresent(
      vtkObject::SafeDownCast(static_cast<vtkObject*>(prop)));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfTuples(); ++k)
    {
      result.insert({ index, ids->GetValue(k) });
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SelectionSame)
{
  PickScene plain(false);
  PickScene passed(true);
  const Pixels before = passed.Window.Grab();
  const std::array<unsigned int, 4> areas[] = { { 0, 0, 119, 99 }, { 40, 20, 80, 60 },
    { 60, 30, 60, 30 } };
  for (int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    for (const auto& area : areas)
    {
      const Selected expected = Select(plain, association, area);
      const Selected found = Select(passed, association, area);
      std::cout << (association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? "cells" : "points")
                << " from " << area[0] << ", " << area[1] << ": " << expected.size()
                << " expected, " << found.size() << " found\n";
      CONTRACT_CHECK(association == vtkDataObject::FIELD_ASSOCIATION_POINTS || !expected.empty(),
        "nothing to select");
      CONTRACT_CHECK(expected == found, "another selection");
    }
  }
  const Difference difference = Compare(before, passed.Window.Grab());
  CONTRACT_CHECK(difference.Max == 0.0, "the picture after a selection: " << difference);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PickingSame)
{
  PickScene plain(false);
  PickScene passed(true);
  for (int y = 5; y < 100; y += 15)
  {
    for (int x = 5; x < 120; x += 15)
    {
      // Props, by hardware; cells, by geometry; points, by the depth buffer.
      int props[2];
      vtkIdType cells[2];
      double points[2][3];
      for (int i = 0; i < 2; ++i)
      {
        vtkRenderer* renderer = (i ? passed : plain).Window.Renderer;
        vtkNew<vtkPropPicker> propPicker;
        propPicker->PickProp(x, y, renderer);
        props[i] = propPicker->GetViewProp()
          ? renderer->GetViewProps()->IsItemPresent(propPicker->GetViewProp())
          : 0;
        vtkNew<vtkCellPicker> cellPicker;
        cellPicker->Pick(x, y, 0, renderer);
        cells[i] = cellPicker->GetCellId();
        // Picking props has drawn identifiers; the next query needs the picture's depth.
        renderer->GetRenderWindow()->Render();
        vtkNew<vtkWorldPointPicker> pointPicker;
        pointPicker->Pick(x, y, 0, renderer);
        pointPicker->GetPickPosition(points[i]);
      }
      CONTRACT_CHECK(props[0] == props[1], "prop at " << x << ", " << y);
      CONTRACT_CHECK(cells[0] == cells[1], "cell at " << x << ", " << y);
      for (int k = 0; k < 3; ++k)
      {
        CONTRACT_CHECK(std::abs(points[0][k] - points[1][k]) < 1e-4,
          "point at " << x << ", " << y << ": " << points[0][k] << ", " << points[1][k]);
      }
    }
  }
}

//------------------------------------------------------------------------------
// The window's depth is the same as without the pass: labels and pickers read it.
VTK_INDIRECT_TEST(DepthSame)
{
  for (bool parallel : { false, true })
  {
    PickScene plain(false);
    PickScene passed(true);
    for (PickScene* scene : { &plain, &passed })
    {
      scene->Window.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene->Window.Window->Render();
    }
    const std::vector<float> expected = GrabDepth(plain.Window.Window);
    const std::vector<float> found = GrabDepth(passed.Window.Window);
    double largest = 0.0;
    size_t background = 0;
    for (size_t i = 0; i < expected.size(); ++i)
    {
      largest = std::max<double>(largest, std::abs(expected[i] - found[i]));
      background += expected[i] == 1.0f ? 1 : 0;
    }
    std::cout << "depth differs by " << largest << ", " << background << " pixels of background\n";
    CONTRACT_CHECK(background > 100 && background < expected.size() - 100, "nothing to see");
    // One step of a 24-bit depth buffer.
    CONTRACT_CHECK(largest <= 1.0 / (1 << 24), largest);
    const double z = passed.Window.Renderer->GetZ(60, 30);
    CONTRACT_CHECK(std::abs(z - plain.Window.Renderer->GetZ(60, 30)) <= 1.0 / (1 << 24), z);
  }
}

//------------------------------------------------------------------------------
// Pixels of surfaces and of the background are distinguished also if the depth planes are so far
// apart that depths round to the background's, and after a prop has moved away.
VTK_INDIRECT_TEST(DepthOfBackground)
{
  for (double nearPlane : { 1.0, 1e-2, 1e-4, 1e-6, 1e-8 })
  {
    auto render = [nearPlane](bool indirect)
    {
      View view(64, 48);
      view.Renderer->SetBackground(0.1, 0.2, 0.4);
      auto wall = MakeQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 });
      view.Renderer->AddActor(wall);
      view.Renderer->AddLight(MakeLight(LightKind::Directional, { 0, 0, 1 }, { 0, 0, 0 }));
      vtkNew<vtkIndirectIlluminationPass> pass;
      if (indirect)
      {
        // Too little to be seen.
        pass->SetIndirectScale(1e-9);
        view.Renderer->SetPass(pass);
      }
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetPosition(0, 0, 5);
      camera->SetFocalPoint(0, 0, 0);
      camera->SetClippingRange(nearPlane, 1000.0);
      std::vector<Pixels> images{ view.Grab() };
      wall->SetPosition(0.7, 0.4, 0.0);
      images.push_back(view.Grab());
      return images;
    };
    const std::vector<Pixels> found = render(true);
    const std::vector<Pixels> expected = render(false);
    CONTRACT_CHECK(Compare(expected[0], expected[1]).Max > 50, "nothing has moved");
    for (size_t i = 0; i < found.size(); ++i)
    {
      const Difference difference = Compare(found[i], expected[i]);
      CONTRACT_CHECK(difference.Max <= 1, "near plane " << nearPlane << ": " << difference);
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// Every number that a camera and a light give away.
std::string Describe(vtkLight* light)
{
  std::ostringstream os;
  os.precision(17);
  auto add = [&](const double* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      os << values[i] << " ";
    }
  };
  double v[3];
  add(light->GetPosition(), 3);
  add(light->GetFocalPoint(), 3);
  light->GetTransformedPosition(v);
  add(v, 3);
  light->GetTransformedFocalPoint(v);
  add(v, 3);
  add(light->GetAmbientColor(), 3);
  add(light->GetDiffuseColor(), 3);
  add(light->GetSpecularColor(), 3);
  add(light->GetAttenuationValues(), 3);
  os << light->GetIntensity() << " " << light->GetSwitch() << " " << light->GetPositional() << " "
     << light->GetExponent() << " " << light->GetConeAngle() << " " << light->GetLightType() << " "
     << light->GetShadowAttenuation() << " " << light->GetTransformMatrix();
  for (int i = 0; light->GetTransformMatrix() && i < 16; ++i)
  {
    os << " " << light->GetTransformMatrix()->GetElement(i / 4, i % 4);
  }
  return os.str();
}

std::string Describe(vtkCamera* camera, vtkRenderer* renderer)
{
  std::ostringstream os;
  os.precision(17);
  auto add = [&](const double* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      os << values[i] << " ";
    }
  };
  auto addMatrix = [&](vtkMatrix4x4* matrix) { add(matrix->GetData(), 16); };
  add(camera->GetPosition(), 3);
  add(camera->GetFocalPoint(), 3);
  add(camera->GetViewUp(), 3);
  add(camera->GetDirectionOfProjection(), 3);
  add(camera->GetClippingRange(), 2);
  add(camera->GetWindowCenter(), 2);
  add(camera->GetViewShear(), 3);
  add(camera->GetViewPlaneNormal(), 3);
  add(camera->GetOrientation(), 3);
  os << camera->GetViewAngle() << " " << camera->GetParallelProjection() << " "
     << camera->GetParallelScale() << " " << camera->GetUseHorizontalViewAngle() << " "
     << camera->GetDistance() << " " << camera->GetThickness() << " "
     << camera->GetUseExplicitProjectionTransformMatrix() << " "
     << camera->GetExplicitProjectionTransformMatrix() << " " << camera->GetUseExplicitAspectRatio()
     << " " << camera->GetExplicitAspectRatio() << " " << camera->GetUseOffAxisProjection() << " "
     << camera->GetEyeAngle() << " " << camera->GetLeftEye() << " " << camera->GetEyeSeparation()
     << " " << camera->GetFocalDisk() << " " << camera->GetFocalDistance() << " "
     << camera->GetUserTransform() << " " << camera->GetUserViewTransform() << " "
     << camera->GetFreezeFocalPoint() << " " << camera->GetRoll() << " "
     << camera->GetReferenceCount() << " ";
  addMatrix(camera->GetModelViewTransformMatrix());
  addMatrix(camera->GetProjectionTransformMatrix(renderer));
  return os.str();
}
}

// Rendering leaves lights and camera as plain VTK leaves them, to the bit, and fires no more
// events.
VTK_INDIRECT_TEST(StateUntouched)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    std::vector<std::string> descriptions[2];
    std::vector<vtkMTimeType> growth[2];
    for (int withPass = 0; withPass < 2; ++withPass)
    {
      View view(100, 80);
      AddRoom(view.Renderer);
      vtkRenderer* renderer = view.Renderer;
      vtkSmartPointer<vtkLight> head = vtkSmartPointer<vtkLight>::New();
      head->SetLightTypeToHeadlight();
      renderer->AddLight(head);
      auto ofCamera = MakeLight(LightKind::Spot, { 0.5, 0.5, 1.0 }, { 0, 0, 0 });
      ofCamera->SetLightTypeToCameraLight();
      renderer->AddLight(ofCamera);
      renderer->AddLight(MakeLight(LightKind::Point, { 0.5, 0.8, 0.5 }, { 0, 0, 0 }));
      vtkCamera* camera = renderer->GetActiveCamera();
      camera->SetParallelProjection(kind == 1);
      if (kind == 2)
      {
        vtkNew<vtkMatrix4x4> projection;
        projection->DeepCopy(camera->GetProjectionTransformMatrix(1.25, -1, 1));
        projection->SetElement(0, 2, 0.1);
        camera->SetExplicitProjectionTransformMatrix(projection);
        camera->UseExplicitProjectionTransformMatrixOn();
      }
      vtkNew<vtkIndirectIlluminationPass> pass;
      if (withPass)
      {
        renderer->SetPass(pass);
      }
      view.Window->Render();
      std::vector<vtkLight*> lights;
      for (int i = 0; i < renderer->GetLights()->GetNumberOfItems(); ++i)
      {
        lights.push_back(vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(i)));
      }
      // Modifications of each in a frame.
      std::vector<vtkObject*> watched(lights.begin(), lights.end());
      watched.push_back(camera);
      growth[withPass].assign(watched.size(), 0);
      vtkNew<vtkCallbackCommand> observers[5];
      for (size_t i = 0; i < watched.size(); ++i)
      {
        observers[i]->SetClientData(&growth[withPass][i]);
        observers[i]->SetCallback([](vtkObject*, unsigned long, void* count, void*)
          { ++*static_cast<vtkMTimeType*>(count); });
        watched[i]->AddObserver(vtkCommand::ModifiedEvent, observers[i]);
      }
      view.Window->Render();
      for (size_t i = 0; i < watched.size(); ++i)
      {
        watched[i]->RemoveObserver(observers[i]);
      }
      CONTRACT_CHECK(renderer->GetActiveCamera() == camera, "another camera");
      std::string cameraText = Describe(camera, renderer);
      std::string pointerFree;
      // Addresses differ between the two windows.
      for (size_t i = 0; i < cameraText.size();)
      {
        if (cameraText.compare(i, 2, "0x") == 0)
        {
          pointerFree += "address";
          i = cameraText.find(' ', i);
          continue;
        }
        pointerFree += cameraText[i++];
      }
      descriptions[withPass].push_back(pointerFree);
      for (vtkLight* light : lights)
      {
        std::string text = Describe(light);
        const size_t at = text.find("0x");
        if (at != std::string::npos)
        {
          text.erase(at, text.find(' ', at) - at);
        }
        descriptions[withPass].push_back(text);
      }
    }
    for (size_t i = 0; i < descriptions[0].size(); ++i)
    {
      CONTRACT_CHECK(descriptions[0][i] == descriptions[1][i],
        "object " << i << ":\n"
                  << descriptions[0][i] << "\nbecame\n"
                  << descriptions[1][i]);
    }
    for (size_t i = 0; i < growth[0].size(); ++i)
    {
      CONTRACT_CHECK(growth[0][i] == growth[1][i],
        "object " << i << " is modified " << growth[1][i] << " times a frame, without the pass "
                  << growth[0][i]);
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// Compares OpenGL's blending with VTK's state whenever a mapper draws.
struct BlendingWatch
{
  vtkOpenGLState* State = nullptr;
  const char* Switched = ""; // switch of blending before each prop's draw: "on", "off"
  int Draws = 0;
  int Differing = 0; // draws whose first buffer differs from VTK's state
  int Mixing = 0;    // draws that blend bits
  vtkNew<vtkCallbackCommand> Command;

  explicit BlendingWatch(View& view)
  {
    this->State = view.Window->GetState();
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* watch, void*)
      { static_cast<BlendingWatch*>(watch)->Execute(event); });
    vtkPropCollection* props = view.Renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      if (auto* actor = vtkActor::SafeDownCast(props->GetItemAsObject(i)))
      {
        actor->GetMapper()->AddObserver(vtkCommand::StartEvent, this->Command);
        // Between the uniforms, which passes set, and the draw.
        actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
      }
    }
  }

  bool Agrees(GLuint buffer) const
  {
    return (glIsEnabledi(GL_BLEND, buffer) == GL_TRUE) == this->State->GetEnumState(GL_BLEND);
  }

  void Execute(unsigned long event)
  {
    if (event == vtkCommand::StartEvent)
    {
      if (*this->Switched)
      {
        this->State->SetEnumState(GL_BLEND, this->Switched == std::string("on"));
      }
      return;
    }
    ++this->Draws;
    this->Differing += this->Agrees(0) ? 0 : 1;
    // The geometry buffer and the lights' maps have the surface's bits in their second buffer.
    GLint second = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER1, &second);
    this->Mixing += second != GL_NONE && glIsEnabledi(GL_BLEND, 1) ? 1 : 0;
  }
};
}

// VTK switches blending for all draw buffers at once and remembers one value. OpenGL has that value
// in the first buffer at every draw, and in all of them after the frame.
VTK_INDIRECT_TEST(BlendingRemembered)
{
  for (const std::string kind : { "plain", "texture", "specular" })
  {
    for (const char* switched : { "", "on", "off" })
    {
      const std::string what = kind + (*switched ? ", switched " : "") + switched;
      View view(80, 60);
      AddRoom(view.Renderer);
      AddKinds(view.Renderer, nullptr, kind);
      vtkNew<vtkIndirectIlluminationPass> pass;
      view.Renderer->SetPass(pass);
      BlendingWatch watch(view);
      watch.Switched = switched;
      view.Window->Render();
      CONTRACT_CHECK(watch.Draws > 10, what << ": only " << watch.Draws << " draws");
      CONTRACT_CHECK(watch.Differing == 0,
        what << ": not as remembered in " << watch.Differing << " of " << watch.Draws << " draws");
      CONTRACT_CHECK(watch.Mixing == 0,
        what << ": bits blended in " << watch.Mixing << " of " << watch.Draws << " draws");
      view.Window->MakeCurrent();
      GLint buffers = 0;
      glGetIntegerv(GL_MAX_DRAW_BUFFERS, &buffers);
      for (GLint i = 0; i < buffers; ++i)
      {
        CONTRACT_CHECK(watch.Agrees(static_cast<GLuint>(i)),
          what << ": after the frame, draw buffer " << i << " is not as remembered");
      }
    }
  }
}

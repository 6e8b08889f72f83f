// SPDX-License-Identifier: BSD-3-Clause
// Other features of a renderer: depth for readers, hidden lines, and messages about switches and
// surrounding passes without effect.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOutlineGlowPass.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkSSAOPass.h"
#include "vtkSelectVisiblePoints.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"

using namespace contract;

namespace
{
// An actor with a vtkLabeledDataMapper, which updates its points while VTK draws opaque props.
class Labels : public vtkActor2D
{
public:
  static Labels* New();
  vtkTypeMacro(Labels, vtkActor2D);
  int RenderOpaqueGeometry(vtkViewport*) override
  {
    this->Points->Update();
    return 1;
  }
  int RenderOverlay(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  vtkSmartPointer<vtkAlgorithm> Points;

protected:
  Labels() = default;
};
vtkStandardNewMacro(Labels);

// Two balls, one before the other, at angles that leave no pixel's depth flat.
struct Balls : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;

  explicit Balls(bool withPass, int samples = 0, int resolution = 32)
    : View(90, 70)
  {
    const Vec3 grey{ 0.8, 0.8, 0.8 };
    this->Window->SetMultiSamples(samples);
    this->Renderer->SetBackground(0.1, 0.1, 0.3);
    this->Renderer->AddActor(MakeSphere({ 0, 0, 0 }, 0.6, grey, resolution));
    this->Renderer->AddActor(MakeSphere({ 0.4, 0.2, -1.2 }, 0.7, grey, resolution));
    this->Renderer->AddLight(MakeLight(LightKind::Directional, { 1, 2, 3 }, { 0, 0, 0 }));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.3, 0.5, 4);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 10);
    if (withPass)
    {
      this->Renderer->SetPass(this->Pass);
    }
  }
};
}

//------------------------------------------------------------------------------
// Readers of the depth buffer find the depth of VTK's drawing; in windows with several samples, if
// something in the scene reads depth, that of the sample that is read.
VTK_INDIRECT_TEST(DepthIsOfVTK)
{
  for (int samples : { 0, 4 })
  {
    Balls plain(false, samples);
    Balls with(true, samples);
    for (Balls* view : { &plain, &with })
    {
      vtkNew<vtkSphereSource> source;
      vtkNew<vtkSelectVisiblePoints> visible;
      visible->SetInputConnection(source->GetOutputPort());
      visible->SetRenderer(view->Renderer);
      vtkNew<vtkPolyDataMapper2D> mapper;
      mapper->SetInputConnection(visible->GetOutputPort());
      vtkNew<vtkActor2D> points;
      points->SetMapper(mapper);
      view->Renderer->AddViewProp(points);
    }
    plain.Grab();
    with.Grab();
    const std::vector<float> expected = GrabDepth(plain.Window);
    const std::vector<float> depth = GrabDepth(with.Window);
    size_t differ = 0;
    for (size_t i = 0; i < expected.size(); ++i)
    {
      differ += expected[i] != depth[i] ? 1 : 0;
    }
    CONTRACT_CHECK(differ == 0, samples << " samples: " << differ << " depths differ");
  }
}

//------------------------------------------------------------------------------
// Labels appear at visible points: the mapper of labels updates its input while VTK draws opaque
// props, and the points look up the depth.
VTK_INDIRECT_TEST(LabelsOfWhatIsSeen)
{
  auto count = [](bool withPass)
  {
    Balls view(withPass);
    vtkNew<vtkSphereSource> source; // as many points in front as behind
    source->SetRadius(0.61);
    source->SetThetaResolution(8);
    source->SetPhiResolution(8);
    vtkNew<vtkSelectVisiblePoints> visible;
    visible->SetInputConnection(source->GetOutputPort());
    visible->SetRenderer(view.Renderer);
    vtkNew<Labels> labels;
    labels->Points = visible;
    view.Renderer->AddViewProp(labels);
    view.Grab();
    // The points choose again after the renderer has changed; VTK shows the choice of its first
    // frame.
    view.Renderer->Modified();
    view.Grab();
    return visible->GetOutput()->GetNumberOfPoints();
  };
  const vtkIdType plain = count(false);
  const vtkIdType with = count(true);
  std::cout << plain << " labels in plain VTK, " << with << " with the pass\n";
  CONTRACT_CHECK(plain > 10 && plain < 40, "the test's own power: " << plain);
  CONTRACT_CHECK(with == plain, with << " labels in place of " << plain);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(HiddenLinesAreRemoved)
{
  auto grab = [](bool withPass, bool remove, std::string* report = nullptr)
  {
    Balls view(withPass, 0, 10); // the lines of the ball in front leave others visible
    view.Pass->AntialiasingOff();
    vtkActorCollection* actors = view.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetRepresentationToWireframe();
      actor->GetProperty()->LightingOff();
    }
    // A caster, too.
    auto floor =
      MakeQuad({ -1.5, -0.9, 0.5 }, { 1.5, -0.9, 0.5 }, { -1.5, -0.9, -2.0 }, { 0.5, 0.5, 0.5 });
    floor->GetProperty()->LightingOff();
    view.Renderer->AddActor(floor);
    view.Renderer->SetUseHiddenLineRemoval(remove);
    const Pixels image = view.Grab();
    if (report)
    {
      *report = view.Pass->GetReport();
    }
    return image;
  };
  const Pixels plain = grab(false, true);
  const Pixels with = grab(true, true);
  const Difference power = Compare(grab(false, false), plain);
  CONTRACT_CHECK(power.Pixels > 100, "the test's own power: " << power);
  const Difference difference = Compare(plain, with);
  CONTRACT_CHECK(difference.Max == 0.0, difference);

  // A user's delegate draws unchanged, and the report says so.
  Balls view(true);
  view.Renderer->GetActors()->GetLastActor()->GetProperty()->SetRepresentationToWireframe();
  view.Renderer->UseHiddenLineRemovalOn();
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  vtkNew<vtkSequencePass> delegate;
  delegate->SetPasses(passes);
  view.Pass->SetDelegatePass(delegate);
  ExpectedErrors errors;
  view.Grab();
  view.Grab();
  CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
  CONTRACT_CHECK(
    !Report(view.Pass).FindReason("left_out", "hidden-line removal of the renderer").empty(),
    view.Pass->GetReport());
}

//------------------------------------------------------------------------------
// A switch without effect is reported by name, once. Unit.Switches* test the others.
VTK_INDIRECT_TEST(SwitchesAreNamed)
{
  const std::string named = "UseSSAO of the renderer";
  Balls view(true);
  view.Renderer->UseSSAOOn();
  ExpectedErrors errors;
  view.Grab();
  view.Grab();
  CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
  CONTRACT_CHECK(errors.GetText().find(named) != std::string::npos, errors.GetText());
  CONTRACT_CHECK(!Report(view.Pass).FindReason("left_out", named).empty(), named);
}

//------------------------------------------------------------------------------
// Surrounding passes that need VTK's mappers' own drawing get their picture as without this pass.
VTK_INDIRECT_TEST(PassesAroundAreRefused)
{
  auto check = [](vtkImageProcessingPass* around)
  {
    Balls plain(false);
    vtkNew<vtkRenderStepsPass> steps;
    around->SetDelegatePass(steps);
    plain.Renderer->SetPass(around);
    // With VTK 9.6 a pixel of the first frame differs from all later ones under an outline.
    plain.Grab();
    const Pixels expected = plain.Grab();
    around->ReleaseGraphicsResources(plain.Window);
    plain.Renderer->SetPass(nullptr);

    Balls view(true);
    around->SetDelegatePass(view.Pass);
    view.Renderer->SetPass(around);
    ExpectedErrors errors;
    view.Grab();
    const Difference difference = Compare(expected, view.Grab());
    const std::string name = around->GetClassName();
    CONTRACT_CHECK(errors.GetCount() == 1, name << ": " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find(name) != std::string::npos, errors.GetText());
    CONTRACT_CHECK(Report(view.Pass).FindReason("modelled", "the delegate alone").find(name) == 0,
      view.Pass->GetReport());
    CONTRACT_CHECK(difference.Max == 0.0, name << ": " << difference);
    around->ReleaseGraphicsResources(view.Window);
    view.Renderer->SetPass(nullptr);
  };
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(0.5);
  occlusion->SetBias(0.01);
  check(occlusion);
  vtkNew<vtkOutlineGlowPass> glow;
  check(glow);
}

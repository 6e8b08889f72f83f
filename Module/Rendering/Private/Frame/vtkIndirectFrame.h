// SPDX-License-Identifier: BSD-3-Clause
// What every stage of a frame needs to know, taken from the scene once at its start.
//
// Scene units: positions are relative to the centre of the scene's bounds and divided by their
// diagonal, so that shaders see numbers of order one whether the scene measures a nanometre or lies
// a million metres from the origin. The transforms are made in double precision here.
#ifndef vtkIndirectFrame_h
#define vtkIndirectFrame_h

#include "vtkType.h" // for numbers

#include <glm/glm.hpp> // for vectors and matrices
#include <string>      // for reasons
#include <vector>      // for lists

class vtkBoundingBox;
class vtkIndirectCoarseLevels;
class vtkIndirectKey;
class vtkIndirectRoom;
class vtkLight;
class vtkLightCollection;
class vtkActor;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkRenderState;
struct vtkIndirectReport;

/** A light that is on, as VTK's shaders will use it. */
struct vtkIndirectLight
{
  vtkLight* Light = nullptr;
  int Index = 0; // N of VTK's lightColorN
  bool Positional = false;
  glm::dvec3 PositionWC{ 0.0 };
  glm::dvec3 DirectionWC{ 0.0, 0.0, -1.0 }; // the way the light travels, unit
  glm::dvec3 Color{ 0.0 };                  // colour times intensity
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };  // c, l, q for world units
  double ConeAngle = 90.0;                  // half angle, degrees; from 90 on there is no cone
  double Exponent = 0.0;
  bool FollowsCamera = false; // headlight or camera light
  bool Headlight = false;
  double ShadowAttenuation = 1.0;
  /** The light's own: radius in world units of a positional one, else angular radius in radians; 0
   * of one that is a point or a single direction, whose shadows are hard. */
  double Size = 0.0;
  /** Lights what faces it, hidden or not, as VTK's own do: no map, and nothing is reflected of it.
   */
  bool Fill = false;

  /** Largest half angle, in degrees, that one perspective face of a map covers. */
  static constexpr double MaximumSingleFaceAngle = 60.0;
  /** VTKI_MAP_... of the light's map; VTKI_MAP_FACES where it depends on where the light is. */
  int FindMapProjection() const;
  /** Appends everything that decides how the light shines on surfaces. */
  void AppendTo(vtkIndirectKey& key) const;
};

/** A prop that casts shadows and reflects light. */
struct vtkIndirectCaster
{
  vtkProp* Prop = nullptr;
  double Bounds[6];
  /** Where it has moved: what maps are fitted to in place of its bounds, see vtkIndirectRoom. */
  double Room[6];
  bool HasRoom = false;
  vtkTypeUInt64 Revision = 0; // see vtkIndirectRevision
  bool SendsLight = true;
  double Triangles = 0.0; // about, of its depth

  const double* GetFit() const { return this->HasRoom ? this->Room : this->Bounds; }
  /** Appends who the caster is, its revision and whether it sends light. */
  void AppendTo(vtkIndirectKey& key) const;
};

struct vtkIndirectFrame
{
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Size[2] = { 0, 0 };
  int Origin[2] = { 0, 0 };

  double SceneBounds[6] = { 0, 0, 0, 0, 0, 0 };
  glm::dvec3 SceneCenter{ 0.0 }; // world
  double SceneScale = 1.0;       // scene units per world unit

  std::vector<vtkProp*> Props;     // all visible ones
  std::vector<vtkProp*> Captured;  // opaque ones whose surfaces the capture gets
  std::vector<vtkProp*> ColorOnly; // other opaque ones: they have a colour, but no surface
  bool Specular = false;        // whether a lit opaque prop reflects specularly, by Phong's model
  bool PhysicallyBased = false; // whether one is lit by VTK's PBR, and so reflects by its lobe
  bool CoversFully = false;     // whether whatever an opaque prop draws hides all that is behind it
  double NumberOfTriangles = 0.0; // about, of opaque props; 1e9 of one whose number is unknown
  int NumberOfOtherReceivers = 0; // captured lit props that are no casters
  std::vector<vtkIndirectCaster> Casters;
  vtkIndirectCoarseLevels* Levels = nullptr; // of them, for depth maps; may be null
  bool AllSendLight = true;                  // whether all surfaces may send light
  std::vector<vtkActor*> Refractors; // translucent ones that are glass, see vtkIndirectPropKind
  bool SendersAreSpecular = false;   // whether some that may reflect specularly
  std::vector<vtkIndirectLight> Lights;
  /** The renderer's own, which what has no surface is drawn with; null: Lights are these. */
  vtkLightCollection* ReplacedLights = nullptr;
  /** Props that take no part, or not the whole, and why. */
  struct LeftOutEntry
  {
    std::string What;
    std::string Why;
    int Count;
    std::vector<std::string> Which; // the first that differ
  };
  std::vector<LeftOutEntry> LeftOut;

  // The eye. View coordinates in the shaders are scaled to scene units.
  bool Parallel = false;
  double Near = 0.0; // scene units
  double Far = 1.0;
  glm::dmat4 WorldToView{ 1.0 }; // unscaled
  glm::dmat4 ViewToScene{ 1.0 }; // from scaled view coordinates
  glm::dmat4 Projection{ 1.0 };  // of unscaled view coordinates
  glm::dmat3 RayOrigin{ 0.0 };   // see vtkiReconstruct
  glm::dmat3 RayDirection{ 0.0 };

  /** Reads the scene. The eye is set up only where something opaque is in a viewport of any size.
   * Bounds have room where one is given; it may rest where nobody waits for the frame. */
  void Build(
    const vtkRenderState* state, vtkIndirectRoom* room = nullptr, bool interactive = false);

  /** Whether a frame is a further part of a picture, which its first part has decided for. */
  bool IsFurtherPart() const;

  /** Transform from an affine frame given in world coordinates to scene units. */
  glm::dmat4 ToScene(const glm::dmat4& frameToWorld) const;
  /** To clip coordinates whose fourth component is of order one, whatever the scene measures:
   * products of three of them stay within floats. */
  glm::mat4 FindSceneToClip() const;

  /** Appends the inputs of an estimate, besides the lights' maps: the eye, the lights, the props.
   */
  void AppendTo(vtkIndirectKey& key) const;
  /** Appends the units of the scene: positions in scene units depend on them. */
  void AppendUnitsTo(vtkIndirectKey& key) const;
  /** Appends the units and the boxes that depth maps are fitted to. */
  void AppendFitsTo(vtkIndirectKey& key) const;
  /** Says what takes no part, once a kind. */
  void AddToReport(vtkIndirectReport& report) const;

  static glm::dmat4 ToGLM(vtkMatrix4x4* matrix);
  /** Length of a box's diagonal, 0 of an empty box. VTK's own answer is infinity then, and ends the
   * program where VTK was built with assertions. */
  static double FindDiagonal(const vtkBoundingBox& box);

private:
  void LeaveOut(vtkProp* prop, const std::string& why);
  void CollectProps(vtkIndirectRoom* room, bool interactive);
  void AddOpaque(vtkProp* prop, vtkBoundingBox& box);
  void CollectLights();
  void SetUpEye();
};

#endif

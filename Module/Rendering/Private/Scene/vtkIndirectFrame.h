// SPDX-License-Identifier: BSD-3-Clause
// The facts about a scene that every stage of a frame needs, collected once at its start.
//
// Scene units: positions are relative to the centre of the scene's bounds and divided by their
// diagonal, so that shaders see numbers of order one whether the scene measures a nanometre or lies
// a million metres from the origin. The transforms are made in double precision here.
#pragma once

#include "Scene/vtkIndirectSeen.h" // for the part that the eye sees
#include "vtkType.h"               // for numbers

#include <glm/glm.hpp> // for vectors and matrices
#include <string>      // for reasons
#include <utility>     // for pairs
#include <vector>      // for lists

class vtkBoundingBox;
class vtkIndirectCoarseLevels;
class vtkIndirectKey;
class vtkIndirectCasterBounds;
class vtkLight;
class vtkLightCollection;
class vtkActor;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkRenderState;
struct vtkIndirectPropKind;

/**
 * An emitter as VTK's shaders use a light: a vtkLight that is on, directions of the sky, or a piece
 * of an area light.
 */
struct vtkIndirectLight
{
  vtkLight* Light = nullptr; // null for the sky and for area lights
  /**
   * N of VTK's lightColorN. An emitter of the sky or of an area light has the same number in any
   * frame, whatever it sends.
   */
  int Index = 0;
  bool Positional = false;
  glm::dvec3 PositionWC{ 0.0 };             // 0 unless it is positional
  glm::dvec3 DirectionWC{ 0.0, 0.0, -1.0 }; // unit direction in which the light travels
  glm::dvec3 Color{ 0.0 };                  // colour times intensity
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };  // c, l, q for world units
  double ConeAngle = 90.0;                  // half angle, degrees; from 90 on there is no cone
  double Exponent = 0.0;
  bool FollowsCamera = false; // headlight or camera light
  bool Headlight = false;
  double ShadowAttenuation = 1.0;
  /**
   * This is the light's size: radius in world units of a positional light, else angular radius in
   * radians; 0: a point or a single direction, whose shadows are hard.
   */
  double Size = 0.0;
  /**
   * It is true if it lights all surfaces that face it, hidden or not, as VTK's own lights do: it
   * has no map, and its light is not reflected.
   */
  bool Fill = false;
  /**
   * It is false if one of VTK's numbers is not finite: the light counts as dark, and has no place.
   */
  bool Finite = true;
  size_t Pieces = 1;   // number of pieces of area lights that it represents
  int FirstBounce = 1; // first bounce that random walks from it keep

  /** Returns true if surfaces reflect its light. */
  bool IsReflected() const { return !this->Fill && this->Color != glm::dvec3(0.0); }
  /** This is the largest half angle, in degrees, that one perspective face of a map covers. */
  static constexpr double MaximumSingleFaceAngle = 60.0;
  /**
   * Returns the projection VTKI_MAP_... of the light's map; VTKI_MAP_FACES where the projection
   * depends on the light's place.
   */
  int FindMapProjection() const;
  /**
   * Returns the attenuation at a distance in world units, times the cone's factor in a unit
   * direction from the light; 0 where VTK's divisor is not positive.
   */
  double FindFalloff(const glm::dvec3& direction, double distance) const;
  /** Appends all properties that decide how the light shines on surfaces. */
  void AppendTo(vtkIndirectKey& key) const;
};

/** This is a prop that casts shadows and reflects light. */
struct vtkIndirectCaster
{
  vtkProp* Prop = nullptr;
  double Bounds[6];
  /**
   * The bounds within which it moves: maps are fitted to them instead of its own, see
   * vtkIndirectCasterBounds.
   */
  double WideBounds[6];
  bool HasWideBounds = false;
  vtkTypeUInt64 Revision = 0; // see vtkIndirectRevision
  bool SendsLight = true;
  double Triangles = 0.0; // approximate number, for depth maps

  const double* GetFit() const { return this->HasWideBounds ? this->WideBounds : this->Bounds; }
  /** Appends the caster's identity, its revision and whether it sends light. */
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

  std::vector<vtkProp*> Props;        // all visible props
  std::vector<vtkProp*> Captured;     // opaque props whose surfaces the capture gets
  std::vector<vtkProp*> ColorOnly;    // other opaque props: they have a colour, but no surface
  std::vector<vtkProp*> Catchers;     // captured props that show the background, shadowed
  std::vector<vtkProp*> WithBackface; // opaque props with a backface property
  bool Specular = false;          // true if a lit opaque prop reflects specularly, by Phong's model
  bool PhysicallyBased = false;   // true if VTK's PBR lights an opaque prop, which thus reflects by
                                  // its lobe
  bool CoversFully = false;       // true if each opaque prop hides everything behind it
  double NumberOfTriangles = 0.0; // approximate, of opaque props; 1e9 for a prop whose number is
                                  // unknown
  int NumberOfOtherReceivers = 0; // captured lit props that are no casters
  std::vector<vtkIndirectCaster> Casters;
  vtkIndirectCoarseLevels* Levels = nullptr; // coarse levels of casters, for depth maps; may be
                                             // null
  bool AllSendLight = true;                  // true if all surfaces may send light
  bool CastersArePhysicallyBased = true;     // true if VTK's PBR lights all casters
  std::vector<vtkActor*> Refractors;         // translucent actors of glass, see vtkIndirectPropKind
  bool SendersAreSpecular = false;           // true if surfaces that send light reflect specularly
  std::vector<vtkIndirectLight> Lights;
  /**
   * The renderer's own lights, for props without a surface; null: Lights are the renderer's own.
   */
  vtkLightCollection* ReplacedLights = nullptr;
  /** These are the props that take no part, or only a partial one, and the reasons. */
  struct LeftOutEntry
  {
    std::string What;
    std::string Why;
    int Count;
    std::vector<std::string> Which; // the first distinct descriptions
  };
  std::vector<LeftOutEntry> LeftOut;

  // The eye. View coordinates in the shaders are scaled to scene units.
  bool Parallel = false;
  double Near = 0.0; // scene units
  double Far = 1.0;
  glm::dmat4 WorldToView{ 1.0 }; // of world coordinates, unscaled
  glm::dmat4 ViewToScene{ 1.0 }; // from scaled view coordinates
  glm::dmat4 Projection{ 1.0 };  // of unscaled view coordinates
  glm::dmat3 RayOrigin{ 0.0 };   // see vtkiReconstruct
  glm::dmat3 RayDirection{ 0.0 };
  glm::dvec3 RaysMeet{ 0.0 }; // where all rays of a perspective meet
  vtkIndirectSeen Seen;       // empty where the picture shows most of the scene

  /**
   * Reads the scene. The eye is set up only if something opaque is in a viewport of any size. If
   * casterBounds is given, casters get wide bounds, their own in a frame that is not interactive.
   */
  void Build(const vtkRenderState* state, vtkIndirectCasterBounds* casterBounds = nullptr,
    bool interactive = false);

  /**
   * Returns true if the frame is a further part of a picture, which follows the decisions of the
   * first part.
   */
  bool IsFurtherPart() const;
  /** Returns true if the frame shows all that the camera sees, and not a tile of the picture. */
  bool IsWhole() const;

  /** Returns one of the eight corners of bounds; the corners 0 and 7 are the lower and upper one.
   */
  static glm::dvec3 GetCorner(const double bounds[6], int i)
  {
    return { bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + ((i >> 2) & 1)] };
  }
  /** Returns a place, given in world coordinates, in scene units. */
  glm::dvec3 ToScene(const glm::dvec3& place) const
  {
    return (place - this->SceneCenter) * this->SceneScale;
  }
  /** Returns a place, given in scene units, in world coordinates. */
  glm::dvec3 ToWorld(const glm::dvec3& place) const
  {
    return place / this->SceneScale + this->SceneCenter;
  }
  /**
   * Returns the corners of the boxes that maps are fitted to, eight for each caster: in scene units
   * from a place, along three axes.
   */
  std::vector<glm::dvec3> FindCorners(const glm::dmat3& axes, const glm::dvec3& place) const;
  /** Returns the place, in scene units, at a depth behind a point of the image, from -1 to 1. */
  glm::dvec3 FindPlace(const glm::dvec2& ndc, double depth) const
  {
    const glm::dvec3 h(ndc, 1.0);
    const glm::dvec3 view = this->RayOrigin * h + depth * (this->RayDirection * h);
    return glm::dvec3(this->ViewToScene * glm::dvec4(view, 1.0));
  }
  /** Returns the transform from an affine frame, given in world coordinates, to scene units. */
  glm::dmat4 ToScene(const glm::dmat4& frameToWorld) const;
  /**
   * Returns the transform to clip coordinates with a fourth component of order one for any scene
   * size: products of three coordinates stay within floats.
   */
  glm::mat4 FindSceneToClip() const;

  /**
   * Appends the inputs of an estimate, except the lights' maps: the eye, the lights, the props.
   */
  void AppendTo(vtkIndirectKey& key) const;
  /** Appends the units of the scene: positions in scene units depend on them. */
  void AppendUnitsTo(vtkIndirectKey& key) const;
  /** Appends the units and the boxes that depth maps are fitted to; after Seen is set. */
  void AppendFitsTo(vtkIndirectKey& key) const;
  /** Returns about how many triangles a depth map of all casters draws. */
  double CountDepthTriangles() const;
  /** Returns the props that take no part, one pair of subject and reason for each class and reason.
   */
  std::vector<std::pair<std::string, std::string>> DescribeLeftOut() const;

  static glm::dmat4 ToGLM(vtkMatrix4x4* matrix);
  /**
   * Rounds a unit vector of the camera: it is the same in each frame while the camera moves without
   * turning, and so is the light of what follows the camera.
   */
  static glm::dvec3 RoundDirection(const glm::dvec3& direction);
  /**
   * Returns the length of a box's diagonal, 0 for an empty box. VTK's own function returns infinity
   * for an empty box, and ends the program if VTK was built with assertions.
   */
  static double FindDiagonal(const vtkBoundingBox& box);

private:
  void LeaveOut(vtkProp* prop, const std::string& why);
  void CollectProps(vtkIndirectCasterBounds* casterBounds, bool interactive);
  void AddOpaque(vtkProp* prop, vtkBoundingBox& box);
  bool AddCatcher(vtkProp* prop, const vtkIndirectPropKind& kind);
  void CollectLights();
  void SetUpEye();
};

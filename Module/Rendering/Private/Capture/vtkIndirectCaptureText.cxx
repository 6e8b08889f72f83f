// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCaptureText.h"

#include "Capture/vtkIndirectCaptureLights.h"
#include "Capture/vtkIndirectLightConstants.h"
#include "OpenGL/vtkIndirectFlatUniforms.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "vtkShaderProgram.h"

namespace
{
const std::string PreLightMarker = "//VTKI::PreLight";

void ReplaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

// Number of lights whose uniforms, and those of their shadows, are passed as flat varyings: 35
// components each, and 50 of all else. With more lights, triangles cost more than pixels save.
// OpenGL on the processor links no more than 128 components (GL_MAX_VARYING_COMPONENTS).
constexpr int MostNamedLights = 3;
constexpr int MostFlatComponents = 128;

bool Contains(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}

// Counts instances and impostors from the scene's centre. Their data place them in floats, which
// VTK's mappers do not shift: far from the origin the product of matrix and position has a rounding
// error larger than the shapes, and a different one in each view. Positions relative to the centre
// are exact, and so is their product with the view.
void CountFromWithin(std::string& vertexShader, bool soft)
{
  const std::string glyph = "vec4 vertex = GCMCMatrix * vertexMC;\n";
  const std::string impostor = "MCVCMatrix * vertexMC";
  std::string declarations = "uniform vec3 vtkiWithin;\nuniform mat4 vtkiWithinToView;\n";
  if (Contains(vertexShader, glyph.c_str()) && Contains(vertexShader, "MCDCMatrix * vertex;"))
  {
    // Subtract from the instance's position first: the source adds small offsets.
    ReplaceAll(vertexShader, glyph,
      glyph +
        "  mat4 vtkiGlyph = GCMCMatrix;\n"
        "  vtkiGlyph[3].xyz -= vtkiWithin;\n"
        "  vec4 vtkiVertex = vtkiGlyph * vertexMC;\n");
    ReplaceAll(vertexShader, "MCVCMatrix * vertex;", "vtkiWithinToView * vtkiVertex;");
    ReplaceAll(vertexShader, "MCDCMatrix * vertex;", "vtkiWithinToClip * vtkiVertex;");
    declarations += "uniform mat4 vtkiWithinToClip;\n";
  }
  else if (!soft && Contains(vertexShader, "radiusMC") && Contains(vertexShader, impostor.c_str()))
  {
    ReplaceAll(vertexShader, impostor, "vtkiWithinToView * vec4(vertexMC.xyz - vtkiWithin, 1.0)");
  }
  else
  {
    return;
  }
  vtkShaderProgram::Substitute(vertexShader, "void main()", declarations + "void main()", false);
}

// Edges of faces have a width in pixels and are left out of maps. VTK draws them within the faces,
// which VTK up to 9.2 widens for this.
void LeaveEdgesOutOfMaps(std::string& geometryShader, std::string& fragmentShader)
{
  if (!Contains(geometryShader, "edgeEqn") || !Contains(fragmentShader, "edgeEqn"))
  {
    return;
  }
  const std::string declaration = "uniform float vtkiLineWidth;";
  auto replace = [&declaration](std::string& text, const std::string& stage, const char* width)
  {
    ReplaceAll(text, "lineWidth", "vtkiLineWidth");
    vtkShaderProgram::Substitute(text, declaration,
      "uniform float lineWidth;\n" + stage +
        "#define vtkiLineWidth (vtkiStage == 0 ? lineWidth : " + width + ")\n",
      false);
  };
  replace(geometryShader, "uniform int vtkiStage;\n", "0.0");
  // So thin that no pixel is near enough to have a share of an edge.
  replace(fragmentShader, "", "-1.0e6");
}
}

//------------------------------------------------------------------------------
void vtkIndirectCaptureText::Prepare(std::string& fragmentShader)
{
  if (!Contains(fragmentShader, PreLightMarker.c_str()))
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Light::Impl", PreLightMarker + "\n  //VTK::Light::Impl", false);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectCaptureText::IsAdded(const std::string& fragmentShader)
{
  return Contains(fragmentShader, "vtkiStage");
}

//------------------------------------------------------------------------------
void vtkIndirectCaptureText::Add(
  std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const
{
  // A map's projection may differ from the eye's; see vtkIndirectDepthTile::SetUp.
  for (std::string* text : { &vertexShader, &geometryShader, &fragmentShader })
  {
    ReplaceAll(*text, "cameraParallel", "vtkiParallel");
  }

  const bool positioned = Contains(fragmentShader, "vertexVC");
  const bool lit = positioned && Contains(fragmentShader, "normalVCVSOutput");
  const bool pbr = Contains(fragmentShader, "vec3 albedo =");
  const bool textured = !pbr && Contains(fragmentShader, "vec4 tcolor =");
  std::string depth = positioned ? "(-vertexVC.z * vtkiSceneScale)" : "vtkiLinearDepth()";

  // VTK draws points as spheres around the place of the point.
  const bool sphere =
    lit && Contains(fragmentShader, "ZCalcR") && !Contains(fragmentShader, "tubeBasis1");
  const std::string normal = sphere ? "vtkiNormalVC" : "normalVCVSOutput";

  // Multiplies VTK's own light colours by the visibility of each light.
  std::string visibility;
  int lights = 0;
  for (;; ++lights)
  {
    const std::string n = std::to_string(lights);
    if (!Contains(fragmentShader, ("uniform vec3 lightColor" + n + ";").c_str()))
    {
      break;
    }
    // The only light code matched as text: VTK computes this cosine of a uniform at every pixel.
    ReplaceAll(fragmentShader, "cos(radians(lightConeAngle" + n + "))",
      vtkIndirectCaptureLights::GetConeCosine(lights));
  }
  // With few lights all uniforms can be varyings.
  const bool flat = this->FlatUniforms && geometryShader.empty();
  const bool named = flat && lights <= MostNamedLights;
  for (const vtkIndirectLightConstants::Group& group : this->LightConstants.GetGroups())
  {
    visibility +=
      lit && group.Lights.back() < lights ? vtkIndirectCaptureLights::GetLookUps(group, named) : "";
  }
  if (lit)
  {
    // Derivatives must precede any discard. Impostors of spheres and sticks have discarded
    // uncovered pixels already; their normal is that of the surface.
    const bool impostor = Contains(fragmentShader, "radiusVCVSOutput") &&
      Contains(fragmentShader, "centerVCVSOutput") && Contains(fragmentShader, "discard");
    // Lines have no facets, nor do the tubes and spheres that VTK draws for lines and points.
    const bool analytic = impostor || Contains(fragmentShader, "tubeBasis1") ||
      Contains(fragmentShader, "ZCalcS") || Contains(fragmentShader, "cross(vec3(fdx.y");
    visibility = std::string("  vec3 vtkiPlaceVC = vertexVC.xyz;\n") +
      (sphere ? "  vec3 vtkiNormalVC = vtkiFindSurface(vertexVC.xyz, normalVCVSOutput, ZCalcR, "
                "vtkiParallel != 0, vtkiPlaceVC);\n"
              : "") +
      "  vec2 vtkiSlope = " +
      (impostor ? "vtkiNormalSlope(normalVCVSOutput, vertexVC.xyz);\n"
                : "vtkiDepthSlope(-vertexVC.z * vtkiSceneScale);\n") +
      (analytic ? "  vec3 vtkiFacetNormalVC = " + normal + ";\n"
                : "  vec3 vtkiFacetNormalVC =\n"
                  "    vtkiFacetNormal(vertexVC.xyz * vtkiSceneScale, normalVCVSOutput);\n"
                  "  float vtkiRayDepth = vtkiDepthOnRay(vertexVC.xyz * vtkiSceneScale);\n") +
      this->LightConstants.GetDeclarations(fragmentShader) + visibility;
    depth = analytic ? "(-vtkiPlaceVC.z * vtkiSceneScale)" : "vtkiRayDepth";
  }
  ReplaceAll(fragmentShader, PreLightMarker, visibility);

  std::string declarations = (this->Shadows ? "#define VTKI_SHADOWS\n" : "") +
    vtkIndirectShaderLibrary::GetText("vtkIndirectCaptureDecFS.glsl");
  if (this->Shadows && this->LightConstants.HasPenumbrae())
  {
    declarations += vtkIndirectShaderLibrary::GetText("vtkIndirectPenumbra.glsl");
  }
  for (int light = 0; light < lights; ++light)
  {
    declarations += "uniform float " + vtkIndirectCaptureLights::GetConeCosine(light) + ";\n";
  }
  for (const vtkIndirectLightConstants::Group& group : this->LightConstants.GetGroups())
  {
    declarations += vtkIndirectCaptureLights::GetDeclarations(group, named);
  }
  if (!Contains(fragmentShader, "uniform int vtkiParallel"))
  {
    declarations += "uniform int vtkiParallel;\n";
  }
  // The sky replaces this part: PBR's diffuse light of the renderer's environment texture.
  if (Contains(fragmentShader, "envMatrix") && Contains(fragmentShader, "vec3 irradiance = "))
  {
    // Since 9.6.1 a part of it is specular: multiple reflections of rough surfaces.
    const std::string both = "(FmsEms + k_D) * irradiance";
    if (Contains(fragmentShader, both.c_str()))
    {
      ReplaceAll(fragmentShader, both, "(FmsEms + vtkiImageLight * k_D) * irradiance");
    }
    else
    {
      ReplaceAll(fragmentShader, "vec3 irradiance = ", "vec3 irradiance = vtkiImageLight * ");
    }
    declarations += "uniform float vtkiImageLight;\n";
  }
  std::string albedo = "diffuseColor";
  if (pbr)
  {
    albedo = "(albedo * (1.0 - metallic))";
  }
  else if (textured)
  {
    albedo = "(diffuseColor * vtkiTextureColor)";
  }
  const char* const kind =
    !lit ? "VTKI_SURFACE_UNLIT" : (pbr ? "VTKI_SURFACE_ENCODED" : "VTKI_SURFACE_LINEAR");
  if (pbr)
  {
    // SetShaderParameters recognises programs with encoded colours by this uniform.
    declarations += "uniform float vtkiLightOfPBR;\n";
  }
  declarations += "#define VTKI_ALBEDO " + albedo + "\n";
  declarations += std::string("#define VTKI_NORMAL ") + (lit ? normal : "vec3(0.0)") +
    "\n#define VTKI_FACET " + (lit ? "vtkiFacetNormalVC" : "vec3(0.0)") + "\n#define VTKI_SLOPE " +
    (lit ? "vtkiSlope" : "vec2(0.0)") + "\n#define VTKI_KIND " + kind + "\n#define VTKI_DEPTH " +
    depth +
    // VTK's PBR divides light of vtkLights by pi, its Phong does not.
    "\n#define VTKI_SENDER_SCALE " +
    (pbr ? "(vtkiMapLight.z * vtkiLightOfPBR / VTKI_PI)" : "vtkiMapLight.z") + "\n";
  if (this->Soft)
  {
    declarations += "#define VTKI_SOFT\n";
  }
  if (this->MapsOnly)
  {
    ReplaceAll(declarations, "uniform int vtkiStage;", "const int vtkiStage = 1;");
  }
  LeaveEdgesOutOfMaps(geometryShader, fragmentShader);
  CountFromWithin(vertexShader, this->Soft);
  // Extensions must precede all but preprocessor directives; see vtkIndirectLibAlbedo.glsl.
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
    std::string("//VTK::System::Dec\n") + vtkIndirectShaderLibrary::Extensions, false);
  vtkShaderProgram::Substitute(fragmentShader, "void main()", declarations + "void main()", false);

  std::string outputs;
  if (textured)
  {
    outputs += Contains(fragmentShader, "showTexturesOnBackface")
      ? "  vec3 vtkiTextureColor = gl_FrontFacing || showTexturesOnBackface ? tcolor.rgb : "
        "vec3(1.0);\n"
      : "  vec3 vtkiTextureColor = tcolor.rgb;\n";
  }
  if (this->Specular)
  {
    // VTK declares these for lit surfaces; its PBR declares them, too, without using them.
    const bool phong = lit && !pbr && Contains(fragmentShader, "vec3 specularColor =") &&
      Contains(fragmentShader, "float specularPower =");
    const bool physical = lit && pbr && Contains(fragmentShader, "vec3 F0 =") &&
      Contains(fragmentShader, "float roughness =");
    const char* const sends = phong ? "vec4(specularColor, specularPower)\n"
      : physical                    ? "vec4(F0, roughness > 0.001 ? -roughness : -0.001)\n"
                                    : "vec4(0.0)\n";
    outputs += std::string("#define VTKI_SPECULAR ") +
      (physical && !this->SpecularOfPBR ? "vec4(0.0)\n" : sends) + "#define VTKI_SPECULAR_SENDER " +
      sends;
  }
  outputs += vtkIndirectShaderLibrary::GetText("vtkIndirectCaptureImplFS.glsl");
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::DepthPeeling::Impl", outputs + "  //VTK::DepthPeeling::Impl", false);
  if (flat)
  {
    vtkIndirectFlatUniforms::Move(vertexShader, fragmentShader, MostFlatComponents);
  }
}

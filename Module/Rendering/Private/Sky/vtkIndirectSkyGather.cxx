// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sky/vtkIndirectSkyGather.h"

#include "Capture/vtkIndirectCreases.h"
#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
const vtkIndirectChannels SkyChannels = {
  { "sky", "vtkiSky", "irradiance that comes directly from the environment", GL_RGBA32F, "-",
    "VTK irradiance" },
};
const char* const SumMeaning = "what is seen of the directions asked; what they would give";
const char* const NearMeaning =
  "what is hidden of the directions over the square of the distance of what hides";
const vtkIndirectChannels SkySumChannels = {
  { "sky.sums", "vtkiSkySums", SumMeaning, GL_RGBA32F, "-", "their unit" },
  { "sky.near", "vtkiSkyNear", NearMeaning, GL_R32F, "-", "their unit" },
};
const vtkIndirectChannels StillChannels = {
  { "sky.sums0", "vtkiSkySums", SumMeaning, GL_RGBA32F, "-", "their unit" },
  { "sky.sums1", "vtkiSkySums1", SumMeaning, GL_RGBA32F, "-", "their unit" },
  { "sky.sums2", "vtkiSkySums2", SumMeaning, GL_RGBA32F, "-", "their unit" },
  { "sky.sums3", "vtkiSkySums3", SumMeaning, GL_RGBA32F, "-", "their unit" },
  { "sky.near", "vtkiSkyNear", NearMeaning, GL_RGBA32F, "-", "their unit" },
};
const vtkIndirectChannels OpenColorChannels = {
  { "sky.openColors", "vtkiOpenColors", "colours of the directions by normals if nothing hid them",
    GL_RGBA32F, "world", "their unit" },
};
const vtkIndirectChannels OpenSkyChannels = {
  { "sky.open", "vtkiOpenSky", "irradiance by normals if nothing hid the sky; of the directions",
    GL_RG32F, "world", "their unit" },
};

// Directions of a draw, at most 146: 16384 bytes, which every OpenGL allows. Long draws stall a
// desktop.
constexpr int SumBlock = 128;
constexpr int StrongTexels = 1024;
// Moving frames find creases at every so many pixels: on five scenes, with a sun or without, relMSE
// to still frames rises by at most 0.07 of it.
constexpr int MovingCreases = 4;
}

//------------------------------------------------------------------------------
vtkIndirectSkyGather::vtkIndirectSkyGather(
  vtkIndirectResource* owner, vtkIndirectDepthMaps& maps, const vtkIndirectSkyGather* first)
  : vtkIndirectFrameLight(owner)
  , First(first)
  , Irradiance(this, SkyChannels, false)
  , Sums{ { this, StillChannels, false }, { this, SkySumChannels, false } }
  , Rows(this, SkySumChannels, false)
  , OpenSky(this, OpenSkyChannels, false)
  , Open(this, SkyChannels, false)
  , OpenColors(this, OpenColorChannels, false)
  , Strong(maps, vtkIndirectDepthMaps::STRONG_SKY)
  , Others(maps, first ? vtkIndirectDepthMaps::FURTHER_SKY : vtkIndirectDepthMaps::SKY)
{
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::UpdateDirections(const Input& input)
{
  const int still = input.Plan.NumberOfStillSkyDirections;
  if (!this->Directions.Update(
        *input.Projection, input.Environment, input.Plan.NumberOfSkyDirections, still))
  {
    return;
  }
  this->OpenSkyIsThere = false;
  std::vector<glm::dvec3> strong;
  for (const Summand& summand : this->Directions.GetStrong())
  {
    strong.push_back(summand.Direction);
  }
  this->Strong.SetDirections(std::move(strong));
  // Each direction has a place, with light or not: it may get light when the environment turns.
  this->Others.SetDirections(this->Directions.GetLattice());
}

//------------------------------------------------------------------------------
// Chooses the others that have maps. Until the first map is drawn it chooses all of them: nothing
// hides a direction without a map.
void vtkIndirectSkyGather::ChooseSummed()
{
  const std::vector<Summand>& others = this->Directions.GetOthers();
  std::vector<size_t> there;
  for (const Summand& summand : others)
  {
    if (this->Others.HasTiles(summand.Number))
    {
      there.push_back(summand.Number);
    }
  }
  const bool all = !this->Visible || there.empty() || there.size() == others.size();
  std::vector<Summand> summed = all ? others : this->Directions.Share(there);
  if (!std::equal(summed.begin(), summed.end(), this->Summed.begin(), this->Summed.end()))
  {
    this->Summed = std::move(summed);
    this->OpenSkyIsThere = false;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  // Casters that come to rest get tighter boxes, and the maps other fits.
  vtkIndirectSkyMaps::AppendFitsTo(key, input.Frame);
  key.Add("sky", input.Environment).Add("pace", input.Plan.NumberOfSkyDirections);
  key.Add("sky", input.Plan.NumberOfStillSkyDirections).Add("pace", input.Plan.SkyBlock);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::Update(const Input& input)
{
  input.Timer.Begin(vtkIndirectStageTimer::Visibility);
  const vtkIndirectFrame& frame = input.Frame;
  this->Visible = input.Plan.SkyIsShadowed;
  if (this->First)
  {
    this->UpdateFiner(input);
    input.Timer.End(vtkIndirectStageTimer::Visibility);
    return true;
  }
  this->UpdateDirections(input);
  std::vector<size_t> others;
  for (const Summand& summand : this->Directions.GetOthers())
  {
    others.push_back(summand.Number);
  }
  this->Strong.Fit(frame);
  this->Others.Fit(frame);
  this->Others.SetSending(others);
  const auto request = [&](vtkIndirectSkyMaps& maps, bool empty, int texels)
  {
    if (!this->Visible || empty)
    {
      maps.Release(frame.Window);
      return;
    }
    maps.Request(frame, texels);
  };
  request(this->Strong, this->Directions.GetStrong().empty(), StrongTexels);
  request(this->Others, others.empty(), input.Plan.SkyTileTexels);
  input.Timer.End(vtkIndirectStageTimer::Visibility);
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectSkyGather::Terms vtkIndirectSkyGather::MakeTerms(
  const std::vector<Summand>& summands, bool strong) const
{
  Terms terms;
  for (size_t k = 0; k < summands.size(); ++k)
  {
    const double unit = strong ? 1.0 : this->Directions.GetUnit();
    terms.push_back({ strong ? k : summands[k].Number, summands[k].Light / vtkMath::Pi() / unit });
  }
  return terms;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::SetBlock(const Input& input, const vtkIndirectProgram& program,
  const vtkIndirectSkyMaps& maps, const Terms& terms, size_t first, size_t size)
{
  const std::vector<glm::vec4> block = maps.MakeBlock(terms, first, size);
  this->Block.Update(input.Frame.Window, block.data(), block.size() * sizeof(glm::vec4));
  this->Block.Activate(program);
  program->SetUniformi("vtkiSkyCount", static_cast<int>(std::min(terms.size() - first, size)));
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::UpdateOpenSky(const Input& input)
{
  constexpr int texels = vtkIndirectKernels::VTKI_OPEN_SKY_TEXELS;
  const bool there = this->OpenSkyIsThere && this->OpenSky.GetFramebuffer();
  if (!this->OpenSky.Resize(input.Frame.Window, texels, texels))
  {
    return false;
  }
  if (!there)
  {
    vtkTextureObject* texture = this->OpenSky.GetTexture(0);
    texture->SetMinificationFilter(vtkTextureObject::Linear);
    texture->SetMagnificationFilter(vtkTextureObject::Linear);
    vtkIndirectSkyDirections::OpenSky open = this->Directions.MakeOpenSky(this->Summed);
    this->OpenSky.Write(0, open.Texels);
    this->OpenFlux = open.Flux;
    this->SummedFlux = open.SummedFlux;
    this->OpenSkyIsThere = true;
    this->OpenColorsAreThere = false;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectSkyGather::MakeEstimate(const Input& input)
{
  const bool still = input.Still && input.Plan.Caching && !this->MapsHaveChanged();
  input.Timer.Begin(vtkIndirectStageTimer::Sky);
  bool summed = still;
  if (this->First)
  {
    summed = this->AddBatch(input);
  }
  else if (!still)
  {
    this->ChooseSummed();
    summed = this->SumAll(input);
  }
  input.Timer.End(vtkIndirectStageTimer::Sky);
  vtkIndirectContribution sky = { vtkIndirectContribution::SKY, &this->Irradiance };
  sky.Open = input.Plan.Catches ? &this->Open : nullptr;
  const bool isLast = input.Batch.Number + 1 == input.Batch.Count;
  return { !summed ? vtkIndirectEstimate::FAILED
      : isLast     ? vtkIndirectEstimate::CONVERGED
                   : vtkIndirectEstimate::REFINING,
    { sky } };
}

//------------------------------------------------------------------------------
// The sums have a texel for each of four pixels, or parts of whole blocks.
bool vtkIndirectSkyGather::Resize(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const int step = this->Step;
  const int part = step > 1 ? step : 2;
  const int factor = step > 1 ? step : 1;
  const int size[2] = { (frame.Size[0] + part - 1) / part * factor,
    (frame.Size[1] + part - 1) / part * factor };
  const auto resize = [&](vtkIndirectTarget& image)
  { return image.Resize(frame.Window, frame.Size[0], frame.Size[1], &input.Geometry.GetTarget()); };
  return resize(this->Irradiance) && this->Sums[step > 1].Resize(frame.Window, size[0], size[1]) &&
    (step == 1 || resize(this->Rows));
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::SumAll(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const int step = this->Step = input.Plan.SkyBlock;
  if (!this->Resize(input) || !this->UpdateOpenSky(input))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  const int creaseStep = input.Plan.Interactive ? MovingCreases : 1;
  bool done = !this->Visible || input.Creases.Update(frame, input.Geometry, creaseStep);
  const vtkIndirectSkyReprojection::Input kept = { frame, input.Geometry, step };
  const bool canKeep = input.Plan.Caching && this->Visible && !this->Summed.empty();
  this->Keeps = canKeep && step > 1 && input.EyeMoved && !this->MapsHaveChanged();
  this->KeepsStill = canKeep && step == 1;
  if (!this->Keeps && !this->KeepsStill)
  {
    this->Reprojection.Release(frame.Window);
  }
  if (this->Summed.empty())
  {
    this->Irradiance.Begin();
    this->Irradiance.Clear();
    this->Irradiance.End();
  }
  else
  {
    done = done && (!this->Keeps || this->Reprojection.Begin(kept)) &&
      this->Smoothing.Resize(
        frame, this->Keeps ? this->Reprojection.GetShares() : input.Geometry.GetTarget()) &&
      this->SumOthers(input, this->MakeTerms(this->Summed, false)) &&
      (step == 1 || this->FilterRows(input)) && this->FilterColumns(input) && this->Smooth(input) &&
      (!this->Keeps || this->Reprojection.Keep(kept)) &&
      (!this->KeepsStill || this->Reprojection.KeepStill(kept, this->Smoothing.GetShares()));
  }
  done = done && (this->Directions.GetStrong().empty() || this->SumStrong(input));
  if (!input.Plan.Catches)
  {
    this->Open.Release(frame.Window);
    return done;
  }
  return done && this->SumOpen(input);
}

//------------------------------------------------------------------------------
std::string vtkIndirectSkyGather::GetDefinitions(int block, int step) const
{
  return std::string(this->Visible ? "#define VTKI_VISIBILITY\n" : "") +
    this->Others.GetDefinition() + "#define VTKI_SKY_BLOCK " + std::to_string(block) +
    "\n#define VTKI_SKY_STEP " + std::to_string(step) + "\n";
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::MapsHaveChanged() const
{
  return this->Strong.GetAtlas().HasChanged() || this->Others.GetAtlas().HasChanged();
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::Activate(
  const Input& input, const vtkIndirectSkyMaps* maps, const vtkIndirectProgram& program)
{
  input.Geometry.ActivateReceivers(program, input.Frame);
  if (maps && this->Visible)
  {
    maps->GetAtlas().Activate(program);
    input.Creases.Activate(program);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::SumOthers(const Input& input, Terms terms)
{
  const int step = this->Step;
  vtkIndirectTarget& sums = this->Sums[step > 1];
  const int part[2] = { sums.GetWidth() / step, sums.GetHeight() / step };
  const size_t size = SumBlock;
  // Neighbours on the sphere go to different places of a block.
  const std::vector<glm::dvec3>& directions = this->Others.GetDirections();
  std::sort(terms.begin(), terms.end(),
    [&directions](const vtkIndirectSkyMaps::Term& a, const vtkIndirectSkyMaps::Term& b)
    { return directions[a.Number].y > directions[b.Number].y; });
  std::vector<Terms> classes(static_cast<size_t>(step) * step);
  for (size_t k = 0; k < terms.size(); ++k)
  {
    classes[k % classes.size()].push_back(terms[k]);
  }
  // A single draw writes; several draws add up.
  const bool adds = input.Batch.Count > 1 ||
    std::any_of(classes.begin(), classes.end(),
      [&](const Terms& list) { return list.empty() || list.size() > size; });

  vtkIndirectFullScreenProgram& kernel = this->SumKernels[step > 1];
  kernel.SetDefinitions(this->GetDefinitions(SumBlock, step) +
    (step > 1 ? this->Reprojection.GetDefinition() : "#define VTKI_SKY_PIXELS 4\n"));
  vtkIndirectProgram program = kernel.Use(input.Frame.Window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = input.Frame.Window->GetState();
  sums.Begin();
  if (adds && input.Batch.Number == 0)
  {
    sums.Clear();
  }
  const vtkIndirectAddition addition(input.Frame.Window, adds);
  this->Activate(input, &this->Others, program);
  this->Reprojection.Activate(program);
  for (int i = 0; i < step * step; ++i)
  {
    const int place[2] = { i % step, i / step };
    if (step > 1)
    {
      state->vtkglViewport(place[0] * part[0], place[1] * part[1], part[0], part[1]);
      program->SetUniform2i("vtkiSkyPart", part);
      program->SetUniform2i("vtkiSkyClass", place);
    }
    const Terms& list = classes[static_cast<size_t>(i)];
    for (size_t first = 0; first < list.size(); first += size)
    {
      this->SetBlock(input, program, this->Others, list, first, size);
      kernel.Draw();
      glFlush();
    }
  }
  sums.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::FilterRows(const Input& input)
{
  const int step = this->Step;
  const vtkIndirectTarget& sums = this->Sums[1];
  const int part[2] = { sums.GetWidth() / step, sums.GetHeight() / step };
  this->RowKernel.SetDefinitions("#define VTKI_SKY_ROWS\n#define VTKI_SKY_STEP " +
    std::to_string(step) + "\n" + this->Reprojection.GetDefinition());
  return this->RowKernel.RunOnSurfaces(input.Frame.Window, this->Rows,
    [&](const vtkIndirectProgram& program)
    {
      this->Activate(input, nullptr, program);
      sums.Activate(0, program);
      sums.Activate(1, program);
      this->Reprojection.Activate(program);
      program->SetUniform2i("vtkiSkyPart", part);
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::FilterColumns(const Input& input)
{
  const bool moving = this->Step > 1;
  const vtkIndirectTarget& sums = moving ? this->Rows : this->Sums[0];
  vtkIndirectFullScreenProgram& kernel = this->ColumnKernels[moving];
  kernel.SetDefinitions(this->GetDefinitions(OwnBlock, this->Step));
  const auto set = [&](const vtkIndirectProgram& program)
  {
    this->Activate(input, moving ? &this->Others : nullptr, program);
    for (int i = 0; i < sums.GetNumberOfChannels(); ++i)
    {
      sums.Activate(i, program);
    }
    this->OpenSky.Activate(0, program);
    vtkIndirectSetUniform(program, "vtkiOpenFlux", this->OpenFlux);
    vtkIndirectSetUniform(program, "vtkiSummedFlux", this->SummedFlux);
    program->SetUniformf("vtkiSkyReach",
      static_cast<float>(vtkIndirectSkySmoothing::Parts * this->FindPartAngle(input)));
    if (moving)
    {
      const Terms terms =
        this->First ? this->MakeOwnBatch(input.Batch) : this->MakeTerms(this->Summed, false);
      this->SetBlock(input, program, this->Others, terms, 0, OwnBlock);
    }
  };
  return this->Keeps
    ? this->Reprojection.DrawFresh(input.Frame.Window, kernel, this->Reprojection.GetShares(), set)
    : kernel.RunOnSurfaces(input.Frame.Window, this->Smoothing.GetShares(), set);
}

//------------------------------------------------------------------------------
// Finds the angle between the middle and the rim of the part of the sky that a direction
// represents.
double vtkIndirectSkyGather::FindPartAngle(const Input& input) const
{
  // Until all maps are there, fewer directions represent the sky.
  const double there = static_cast<double>(this->Summed.size()) /
    static_cast<double>(std::max<size_t>(this->Directions.GetOthers().size(), 1));
  const int count =
    this->First ? this->DirectionsOfBatch * input.Batch.Count : input.Plan.NumberOfSkyDirections;
  return 2.0 / std::sqrt(count * there);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::Smooth(const Input& input)
{
  return this->Smoothing.Run({ input.Frame, input.Geometry, this->FindPartAngle(input),
                               this->Visible, this->Step > 1 && !this->First,
                               this->Keeps ? &this->Reprojection : nullptr, this->KeepsStill },
    this->Irradiance,
    [this](const vtkIndirectProgram& program)
    {
      this->OpenSky.Activate(0, program);
      vtkIndirectSetUniform(program, "vtkiOpenFlux", this->OpenFlux);
      program->SetUniformf("vtkiSkyUnit", static_cast<float>(this->Directions.GetUnit()));
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::SumStrong(const Input& input)
{
  const Terms terms = this->MakeTerms(this->Directions.GetStrong(), true);
  this->StrongKernel.SetDefinitions(this->GetDefinitions(SumBlock, 1) + "#define VTKI_FILTERED\n");
  const vtkIndirectAddition addition(input.Frame.Window);
  return this->StrongKernel.Run(input.Frame.Window, this->Irradiance,
    [&](const vtkIndirectProgram& program)
    {
      this->Activate(input, &this->GetStrong(), program);
      // There are at most 32 strong directions.
      this->SetBlock(input, program, this->GetStrong(), terms, 0, SumBlock);
    });
}

//------------------------------------------------------------------------------
// Finds the same light if nothing hid the sky, at surfaces that catch light.
bool vtkIndirectSkyGather::SumOpen(const Input& input)
{
  constexpr int texels = vtkIndirectKernels::VTKI_OPEN_SKY_TEXELS;
  const bool there = this->OpenColorsAreThere && this->OpenColors.GetFramebuffer();
  if (!this->Open.Resize(input.Frame.Window, input.Frame.Size[0], input.Frame.Size[1]) ||
    !this->OpenColors.Resize(input.Frame.Window, texels, texels))
  {
    return false;
  }
  if (!there)
  {
    vtkTextureObject* texture = this->OpenColors.GetTexture(0);
    texture->SetMinificationFilter(vtkTextureObject::Linear);
    texture->SetMagnificationFilter(vtkTextureObject::Linear);
    const vtkIndirectSkyDirections::OpenColors open = this->Directions.MakeOpenColors(this->Summed);
    this->OpenColors.Write(0, open.Texels);
    this->ColorFlux = open.Flux;
    this->OpenColorsAreThere = true;
  }
  const Terms terms = this->MakeTerms(this->Directions.GetStrong(), true);
  this->OpenKernel.SetDefinitions(
    "#define VTKI_FILTERED\n#define VTKI_SKY_BLOCK " + std::to_string(OwnBlock) + "\n");
  return this->OpenKernel.Run(input.Frame.Window, this->Open,
    [&](const vtkIndirectProgram& program)
    {
      this->Activate(input, nullptr, program);
      this->OpenSky.Activate(0, program);
      this->OpenColors.Activate(0, program);
      vtkIndirectSetUniform(program, "vtkiOpenFlux", this->OpenFlux);
      vtkIndirectSetUniform(program, "vtkiColorFlux", this->ColorFlux);
      program->SetUniformf("vtkiSkyUnit", static_cast<float>(this->Directions.GetUnit()));
      this->SetBlock(input, program, this->Strong, terms, 0, OwnBlock);
    });
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::AddToReport(vtkIndirectReport& report) const
{
  const size_t counts[] = { this->Directions.GetStrong().size(),
    this->Directions.GetOthers().size() };
  std::string maps;
  for (int i = 0; this->Visible && i < 2; ++i)
  {
    const vtkIndirectSkyMaps& group = i == 0 ? this->Strong : this->Others;
    maps += counts[i] == 0 ? ""
                           : (maps.empty() ? "; depth maps: " : ", ") + std::to_string(counts[i]) +
        " of " + group.DescribeTexels();
  }
  std::string what = std::to_string(this->Summed.size()) + " directions";
  what += this->Step > 1 ? ", a pixel of " + std::to_string(this->Step * this->Step) +
      " asks each, averaged over its surface"
                         : "";
  what += counts[0] > 0 ? "; strong ones: " + std::to_string(counts[0]) : "";
  report.Modelled.emplace_back("light from the sky", what + maps);
  if (this->Reprojection.IsReprojected())
  {
    report.Modelled.emplace_back("reprojection of the sky", this->Reprojection.GetMeaning());
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::ReleaseOwn(vtkWindow* window)
{
  this->OpenSkyIsThere = this->OpenColorsAreThere = false;
  if (!this->First)
  {
    this->Strong.Release(window);
  }
  this->Others.Release(window);
  this->Directions.Forget();
}

// SPDX-License-Identifier: BSD-3-Clause
// The order in which a still picture is refined: how many virtual lights each refinement has, which
// batch of lights comes next, how much of the finer picture is shown, and when the work ends.
#pragma once

#include "Plan/vtkIndirectEstimate.h" // for a batch

class vtkIndirectRefinementSchedule
{
public:
  static constexpr int LightsOfFirst = 512; // about as many as a picture has at first
  static constexpr int LightsOfBatch = 64;
  static constexpr int StepsOfFade = 8; // frames in which a finer picture takes the place of one

  /** Paths correct more than further lights do. */
  static constexpr int MostLightsWithPaths = 4 * LightsOfFirst;

  struct LimitType
  {
    int Refinements = 0;  // each has four times the lights of the one before
    double Seconds = 0.0; // 0: none; else one refinement has as many lights as there is time for
    bool Fades = false;   // somebody sees each frame
    bool Grows = true;    // further refinements sum more lights, else they trace paths alone
  };

  /** Seconds of a clock that nobody sets. */
  static double ReadClock();
  /**
   * Limits of this frame. With other seconds the refinement under way begins anew. now, here and
   * below: ReadClock, or a time of a test.
   */
  void SetLimits(const LimitType& limits, double now);
  /** A picture has come. */
  void Restart(double now);
  /** The picture is good enough, or there is no time: no more batches until the next restart. */
  void End() { this->HasEnded = true; }
  /** No more batches until Forgive, after an error. */
  void Refuse() { this->IsRefused = true; }
  void Forgive() { this->IsRefused = false; }

  /** Begins a frame that adds something, if there is time. */
  void BeginFrame(double now);
  bool HasBatch() const;
  /** Returns true if the first batch of the first refinement comes next. */
  bool IsAtFirst() const { return this->HasBatch() && this->Refinement + this->Batches == 0; }
  /** The lights of the refinement under way. */
  int GetNumberOfLights() const;
  /** The batch of lights, and the part of a round of paths, that comes next. */
  vtkIndirectLightBatch GetBatch() const;
  vtkIndirectLightBatch GetPart() const;
  /** Returns true if the refinement under way sums lights, and if the next batch does. */
  bool IsOfLights() const { return this->Refinement == 0 || this->Limits.Grows; }
  bool SumsLights() const;
  /** Returns true if the next batch is the first of its refinement. */
  bool IsAtBegin() const { return this->Batches == 0; }
  /** Ends a batch; true: all batches of the refinement are there. */
  bool EndBatch(double now);

  /** Refinements that are there. */
  int GetRefinements() const { return this->Refinement; }
  /** The lights of the last one of these; 0: there is none. */
  int GetLightsOfPicture() const { return this->Finished; }
  /** The share, up to 1, of the finer picture in what is shown. */
  double GetShare() const;
  /** Frames, one for each batch or step of a fade, until nothing changes any more. */
  long long CountFramesLeft() const;

private:
  void Begin(double now);
  void Measure(double now);
  int CountBatches() const;
  bool AddsRound(double now);

  LimitType Limits;
  int Refinement = 0; // the one that is under way, or comes next
  int Batches = 0;    // that are summed of the refinement
  int Lights = 0;     // of the refinement within Limits.Seconds
  int Rounds = 1;     // of paths within Limits.Seconds
  int Finished = 0;   // lights of the last refinement that is there
  int Fade = StepsOfFade;
  bool IsMeasured = false;
  bool HasEnded = false;
  bool IsRefused = false;
  double Began = 0.0;
  double LastEnd = 0.0; // of a batch
  double RoundBegan = 0.0;
};

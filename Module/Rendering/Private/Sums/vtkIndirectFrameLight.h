// SPDX-License-Identifier: BSD-3-Clause
// A sum of light that the frame adds to VTK's own shading: bounces, the sky, area lights. The
// pipeline treats all sums alike: it compares the key of their inputs, lets them ask for depth
// maps, and hands their contributions to the composite.
#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "Plan/vtkIndirectEstimate.h"   // for inputs and results
#include "vtkType.h"                    // for times

#include <cstddef> // for size_t

class vtkIndirectKey;
struct vtkIndirectReport;

class vtkIndirectFrameLight : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;
  using Input = vtkIndirectEstimateInput;

  /** Appends the inputs of the result, except those that all light of the frame depends on. */
  virtual void AppendTo(vtkIndirectKey& key, const Input& input) const = 0;

  /**
   * Brings virtual lights up to date, and asks for depth maps (vtkIndirectDepthMaps). Returns
   * false, after an error, when OpenGL refuses. If Input::Still is true, the key has not changed
   * since the last result.
   */
  virtual bool Update(const Input&) { return true; }
  /** Returns true if all depth maps of the last frame are present and up to date. */
  virtual bool IsComplete() const { return this->GetNumberOfTilesLeft() == 0; }
  /**
   * Returns the number of depth maps that further frames draw, including maps that refine the
   * result.
   */
  virtual int GetNumberOfTilesLeft() const { return 0; }
  /** Returns true if a further frame of the same scene would have more virtual lights. */
  virtual bool HasMore(const Input&) const { return false; }

  /** Computes the light, after depth maps have been drawn. */
  virtual vtkIndirectEstimate MakeEstimate(const Input& input) = 0;
  /**
   * Grows when another user replaces or releases the images: a result is valid as long as this
   * number is the same as right after MakeEstimate.
   */
  virtual vtkMTimeType GetEstimateTime() const { return 0; }
  /** Releases the resources that only frames with this light need. */
  virtual void Rest(const Input&) {}

  /** Returns the bytes of data in main memory. */
  virtual size_t GetMainMemoryBytes() const { return 0; }
  /** Adds what the last frame modelled and left out to the report. */
  virtual void AddToReport(vtkIndirectReport& report) const = 0;
};

// SPDX-License-Identifier: BSD-3-Clause
// Every texel of every map as a virtual light of its own: the reference that others converge to.
#ifndef vtkIndirectAllTexelsSampler_h
#define vtkIndirectAllTexelsSampler_h

#include "vtkMapLightSampler.h"
#include "vtkObjectFactory.h"

class vtkIndirectAllTexelsSampler : public vtkMapLightSampler
{
public:
  static vtkIndirectAllTexelsSampler* New() { VTK_STANDARD_NEW_BODY(vtkIndirectAllTexelsSampler); }
  vtkTypeMacro(vtkIndirectAllTexelsSampler, vtkMapLightSampler);

  void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) override
  {
    for (const Source& source : sources)
    {
      for (int j = 0; j < source.Size[1]; ++j)
      {
        for (int i = 0; i < source.Size[0]; ++i)
        {
          pattern.push_back({ (i + 0.5f) / source.Size[0], (j + 0.5f) / source.Size[1],
            static_cast<float>(source.Layer), 1.0f });
        }
      }
    }
  }

protected:
  vtkIndirectAllTexelsSampler() = default;
  ~vtkIndirectAllTexelsSampler() override = default;

private:
  vtkIndirectAllTexelsSampler(const vtkIndirectAllTexelsSampler&) = delete;
  void operator=(const vtkIndirectAllTexelsSampler&) = delete;
};

#endif

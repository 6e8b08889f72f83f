// SPDX-License-Identifier: BSD-3-Clause
// Changes one of the settings that an estimator's preset makes, for tests of its effect.
#ifndef vtkIndirectDetails_h
#define vtkIndirectDetails_h

#include "Multiresolution/vtkIndirectSubsplatDetails.h" // for its fields
#include "RadianceHints/vtkIndirectHintDetails.h"       // for its fields

inline vtkIndirectSubsplatDetails& DetailsOf(const vtkMultiresolutionSplattingPass* pass)
{
  return vtkIndirectSubsplatDetails::Of(pass);
}
inline vtkIndirectHintDetails& DetailsOf(const vtkRadianceHintsPass* pass)
{
  return vtkIndirectHintDetails::Of(pass);
}

#define SET_DETAIL(pass, name, value)                                                              \
  do                                                                                               \
  {                                                                                                \
    DetailsOf(pass).name = value;                                                                  \
    (pass)->Modified();                                                                            \
  } while (false)

#endif

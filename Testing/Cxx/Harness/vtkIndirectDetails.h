// SPDX-License-Identifier: BSD-3-Clause
// Changes one of the settings that an estimator's preset makes, for tests of its effect.
#ifndef vtkIndirectDetails_h
#define vtkIndirectDetails_h

#include "Multiresolution/vtkIndirectSubsplatDetails.h" // for its fields
#include "RadianceHints/vtkIndirectHintDetails.h"       // for its fields

#define SET_DETAIL(pass, name, value)                                                              \
  do                                                                                               \
  {                                                                                                \
    auto details = (pass)->GetDetails();                                                           \
    details.name = value;                                                                          \
    (pass)->SetDetails(details);                                                                   \
  } while (false)

#endif

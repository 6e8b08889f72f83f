// SPDX-License-Identifier: BSD-3-Clause
// Gives the project's own code the parts of environment lights and area lights that users do not
// need: an image's light in pieces.
#pragma once

#include "vtkAreaLight.h"        // for radiances
#include "vtkEnvironmentLight.h" // for cells
#include "vtkSmartPointer.h"     // for lists

#include <vector> // for lists

struct vtkIndirectEmitterAccess
{
  /** A piece of the sky, with its light and the light's direction. */
  using Cell = vtkEnvironmentLight::Cell;

  /**
   * Returns the whole sky in cells of at most 1.4 degrees, none of them dark. The cells are
   * integrals of the image, so that a small bright sun loses nothing. Empty if there is no light at
   * all, or after an error.
   */
  static const std::vector<Cell>& GetCells(vtkEnvironmentLight* light) { return light->GetCells(); }
  /** Finds the greatest radiance of all directions, for each colour separately. */
  static void GetGreatestRadiance(vtkEnvironmentLight* light, double radiance[3])
  {
    light->GetGreatestRadiance(radiance);
  }

  /**
   * Returns the radiances of a light's pieces, three floats a piece, Scale included: `columns`
   * along Point1 - Origin times `rows`, the piece at Origin first. A light without an image has one
   * piece. Empty after an error.
   */
  static const std::vector<float>& GetRadiances(vtkAreaLight* light, int& columns, int& rows)
  {
    return light->GetRadiances(columns, rows);
  }
  /**
   * Returns true if a light is on and fit for a scene of this centre and size: its corners are
   * finite, no farther away than 1e9 sizes and span an area, its edges are no shorter than 1e-9
   * sizes, and its radiance can be read. Otherwise one error gives the reason, until the light
   * changes.
   */
  static bool ShinesInto(vtkAreaLight* light, const double center[3], double size)
  {
    return light->ShinesInto(center, size);
  }
};

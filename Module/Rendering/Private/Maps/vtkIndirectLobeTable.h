// SPDX-License-Identifier: BSD-3-Clause
// Linearly transformed cosines for the specular lobe of VTK's PBR: roughness, view, entry. The data
// file holds a roughness per line; Testing/Reference/fit_lobes.py writes it and explains the
// numbers.
#pragma once

constexpr int vtkIndirectLobeEntries = 24;
constexpr float vtkIndirectLeastRoughness = 0.06f;
constexpr float vtkIndirectLobeTable[vtkIndirectLobeEntries][vtkIndirectLobeEntries][6] = {
#include "Maps/vtkIndirectLobeTable.inl"
};

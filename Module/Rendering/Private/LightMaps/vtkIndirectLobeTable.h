// SPDX-License-Identifier: BSD-3-Clause
// Linearly transformed cosines for the specular lobe of VTK's PBR: roughness, view, entry. The data
// file holds a roughness per line, and Testing/Reference/fit_lobes.py, which says what the numbers
// are, writes it.
#ifndef vtkIndirectLobeTable_h
#define vtkIndirectLobeTable_h

constexpr int vtkIndirectLobeEntries = 24;
constexpr float vtkIndirectLeastRoughness = 0.06f;
constexpr float vtkIndirectLobeTable[vtkIndirectLobeEntries][vtkIndirectLobeEntries][6] = {
#include "LightMaps/vtkIndirectLobeTable.inl"
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkEGLHeadlessRenderWindow on machines and devices that are made up: runs the one that
// is named.
#include "HeadlessTestTools.h"

using namespace headlesstest;

int main(int argc, char* argv[])
{
  TestMap tests = GetDiagnosisTests();
  tests.merge(GetMachineTests());
  tests.merge(GetDeviceTests());
  return RunNamedTest(tests, argc, argv);
}

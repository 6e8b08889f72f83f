// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectHarness.h"

int main(int argc, char* argv[])
{
  return vtkIndirectTest::Main(argc, argv);
}

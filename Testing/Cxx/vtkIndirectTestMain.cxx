// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectTestUtilities.h"

int main(int argc, char* argv[])
{
  return vtkIndirectTest::Main(argc, argv);
}

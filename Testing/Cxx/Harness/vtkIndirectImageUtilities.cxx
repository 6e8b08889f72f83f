// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectImageUtilities.h"

#include "vtkImageData.h"
#include "vtkPNGReader.h"
#include "vtkRegressionTestImage.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

//------------------------------------------------------------------------------
bool contract::PrepareImageTest()
{
  if (!vtkEGLHeadlessRenderWindow::IsSupported())
  {
    std::cout << "No OpenGL context without a display can be made here\n";
    return false;
  }
  vtkIndirectHeadlessFactory::Enable();
  return true;
}

//------------------------------------------------------------------------------
int contract::CompareWithBaseline(int argc, char* argv[], vtkRenderWindow* window)
{
  constexpr int allowedStep = 4;
  constexpr double allowedShare = 0.01;
  constexpr double allowedMean = 0.3;

  const int verdict = vtkRegressionTestImage(window);
  if (verdict != vtkRegressionTester::PASSED)
  {
    return EXIT_FAILURE;
  }
  const char* path = nullptr;
  for (int i = 1; i + 1 < argc; ++i)
  {
    path = std::strcmp(argv[i], "-V") == 0 ? argv[i + 1] : path;
  }
  if (!path)
  {
    std::cerr << "No baseline: -V is missing\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path);
  reader->Update();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  vtkImageData* images[2] = { reader->GetOutput(), filter->GetOutput() };
  for (int k = 0; k < 3; ++k)
  {
    if (images[0]->GetDimensions()[k] != images[1]->GetDimensions()[k])
    {
      std::cerr << "The baseline has another size\n";
      return EXIT_FAILURE;
    }
  }
  const int components[2] = { images[0]->GetNumberOfScalarComponents(),
    images[1]->GetNumberOfScalarComponents() };
  const vtkIdType pixels = images[0]->GetNumberOfPoints();
  const auto* a = static_cast<const unsigned char*>(images[0]->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(images[1]->GetScalarPointer());
  double mean = 0.0;
  int largest = 0;
  vtkIdType off = 0;
  for (vtkIdType i = 0; i < pixels; ++i, a += components[0], b += components[1])
  {
    int step = 0;
    for (int c = 0; c < 3; ++c)
    {
      step = std::max(step, std::abs(a[c] - b[c]));
      mean += std::abs(a[c] - b[c]);
    }
    largest = std::max(largest, step);
    off += step > allowedStep ? 1 : 0;
  }
  mean /= 3.0 * static_cast<double>(pixels);
  const double share = static_cast<double>(off) / static_cast<double>(pixels);
  std::cout << "Largest difference " << largest << ", mean " << mean << " (up to " << allowedMean
            << "), " << 100.0 * share << " % of the pixels off by more than " << allowedStep
            << " (up to " << 100.0 * allowedShare << " %)\n";
  return mean <= allowedMean && share <= allowedShare ? EXIT_SUCCESS : EXIT_FAILURE;
}

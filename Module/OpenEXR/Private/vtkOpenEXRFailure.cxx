// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRFailure.h"

#include "vtkErrorCode.h"

#include <exception>
#include <new>

//------------------------------------------------------------------------------
vtkOpenEXRFailure vtkOpenEXRFailure::FromCurrentException(unsigned long code)
{
  try
  {
    throw;
  }
  catch (const vtkOpenEXRFailure& failure)
  {
    return failure;
  }
  catch (const std::bad_alloc&)
  {
    return { vtkErrorCode::UnknownError, "there is not enough memory." };
  }
  catch (const std::exception& e)
  {
    return { code, OneLine(e.what()) };
  }
  catch (...)
  {
    return { vtkErrorCode::UnknownError, "unknown exception." };
  }
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRFailure::OneLine(std::string text)
{
  for (char& c : text)
  {
    c = static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return text;
}

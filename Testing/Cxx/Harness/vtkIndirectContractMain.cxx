// SPDX-License-Identifier: BSD-3-Clause
// The program of the contract tests: fails a test for every unexpected error or warning of VTK.
#include "vtkIndirectContractUtilities.h"

#include "vtkLogger.h"

#include <cstring>

namespace
{
constexpr int MaximumPrinted = 12;

// Errors and warnings of VTK.
bool ErrorsAreExpected = false;
int ErrorCount = 0;
std::string ErrorText;
std::string AllowedWarning;

// A window's one message in a process on a machine whose card does not render, which is not an
// error of a pass.
const char* const MachineWarning = "although there is a graphics card";

void CountMessage(void*, const vtkLogger::Message& message)
{
  if (message.verbosity == vtkLogger::VERBOSITY_WARNING &&
    (std::strstr(message.message, MachineWarning) ||
      (!AllowedWarning.empty() && std::strstr(message.message, AllowedWarning.c_str()))))
  {
    return;
  }
  ++ErrorCount;
  ErrorText += std::string(message.message) + "\n";
  if (!ErrorsAreExpected)
  {
    contract::Fail("VTK", 0, message.message);
  }
}
}

namespace contract
{
//------------------------------------------------------------------------------
void Fail(const char* file, int line, const std::string& what)
{
  vtkIndirectTest::AddFailure();
  if (vtkIndirectTest::GetNumberOfFailures() <= MaximumPrinted)
  {
    const char* slash = std::strrchr(file, '/');
    std::cerr << "FAILED " << (slash ? slash + 1 : file) << ":" << line << ": " << what << "\n";
  }
}

//------------------------------------------------------------------------------
void AllowWarning(const std::string& text)
{
  AllowedWarning = text;
}

//------------------------------------------------------------------------------
ExpectedErrors::ExpectedErrors()
{
  ErrorsAreExpected = true;
  ErrorCount = 0;
  ErrorText.clear();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

ExpectedErrors::~ExpectedErrors()
{
  ErrorsAreExpected = false;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
}

int ExpectedErrors::GetCount() const
{
  return ErrorCount;
}

std::string ExpectedErrors::GetText() const
{
  return ErrorText;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  vtkLogger::Init();
  vtkLogger::AddCallback("contract", CountMessage, nullptr, vtkLogger::VERBOSITY_WARNING);
  return vtkIndirectTest::Main(argc, argv,
    [](const std::string&)
    {
      if (!vtkEGLHeadlessRenderWindow::IsSupported())
      {
        vtkIndirectTest::Skip("no OpenGL context without a display can be made here");
      }
      // A test without other checks still checks for VTK's errors.
      vtkIndirectTest::AddCheck();
    });
}

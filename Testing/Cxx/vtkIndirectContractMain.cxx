// SPDX-License-Identifier: BSD-3-Clause
// The program around the contract tests: runs one of them by its name, and fails it for every error
// or warning of VTK that it did not expect.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectTestList.h"

#include "vtkLogger.h"

#include <cstring>
#include <map>

namespace
{
constexpr int SkipReturnCode = 125;
constexpr int MaximumPrinted = 12;
int Failures = 0;

struct SkippedTest
{
  std::string Reason;
};

// Built before main by the tests themselves.
std::map<std::string, void (*)()>& GetTests()
{
  static std::map<std::string, void (*)()> tests;
  return tests;
}

// Errors and warnings of VTK.
bool ErrorsAreExpected = false;
int ErrorCount = 0;
std::string ErrorText;
std::string AllowedWarning;

// What the window says once in a process on a machine whose card does not render: no pass's fault.
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
  if (++Failures <= MaximumPrinted)
  {
    const char* slash = std::strrchr(file, '/');
    std::cerr << "FAILED " << (slash ? slash + 1 : file) << ":" << line << ": " << what << "\n";
  }
}

//------------------------------------------------------------------------------
void Skip(const std::string& reason)
{
  throw SkippedTest{ reason };
}

//------------------------------------------------------------------------------
bool Register(const char* name, void (*function)())
{
  GetTests()[name] = function;
  return true;
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
  const auto& tests = GetTests();
  if (vtkIndirectTest::WantsList(argc, argv))
  {
    return vtkIndirectTest::List(tests, argc, argv);
  }
  const auto found = argc > 1 ? tests.find(argv[1]) : tests.end();
  if (found == tests.end())
  {
    std::cerr << "Usage: " << argv[0] << " TEST, one of";
    for (const auto& test : tests)
    {
      std::cerr << " " << test.first;
    }
    std::cerr << "\n";
    return EXIT_FAILURE;
  }
  if (!vtkEGLHeadlessRenderWindow::IsSupported())
  {
    std::cout << "Skipped: no OpenGL context without a display can be made here\n";
    return SkipReturnCode;
  }
  try
  {
    found->second();
  }
  catch (const SkippedTest& skipped)
  {
    std::cout << "Skipped: " << skipped.Reason << "\n";
    return Failures ? EXIT_FAILURE : SkipReturnCode;
  }
  if (Failures)
  {
    std::cerr << Failures << " checks failed\n";
  }
  return Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}

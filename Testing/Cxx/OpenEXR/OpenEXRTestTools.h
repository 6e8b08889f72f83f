// SPDX-License-Identifier: BSD-3-Clause
// Shared parts of the tests of VTK::IndirectOpenEXR.

#ifndef OpenEXRTestTools_h
#define OpenEXRTestTools_h

#include "vtkIndirectHarness.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenEXRReader.h"
#include "vtkOpenEXRWriter.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include "vtkMemoryResourceStream.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace exrtest
{
#define EXR_CHECK(condition)                                                                       \
  do                                                                                               \
  {                                                                                                \
    vtkIndirectTest::AddCheck();                                                                   \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << "FAILED " << __FILE__ << ":" << __LINE__ << ": " #condition << "\n";            \
      vtkIndirectTest::AddFailure();                                                               \
    }                                                                                              \
  } while (false)

// PCG32 (O'Neill): the same numbers everywhere.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed * 6364136223846793005ull + 1442695040888963407ull)
  {
    this->Next();
  }

  std::uint32_t Next()
  {
    const std::uint64_t old = this->State;
    this->State = old * 6364136223846793005ull + 1442695040888963407ull;
    const std::uint32_t shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
    const std::uint32_t rotation = static_cast<std::uint32_t>(old >> 59u);
    return (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
  }

  std::uint32_t Below(std::uint32_t bound) { return this->Next() % bound; }

  // In [-range, range].
  float Value(float range)
  {
    return range * (static_cast<float>(this->Next() >> 8) / 8388608.0f - 1.0f);
  }

private:
  std::uint64_t State;
};

// Counts the errors and warnings of one object; all others go to the window.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }
  vtkTypeMacro(Messages, vtkCommand);
  int Errors = 0;
  int Warnings = 0;
  std::string Text;

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    (event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings) += 1;
    this->Text = data ? static_cast<const char*>(data) : "";
  }

  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }

  // The message without VTK's own lines about the place and the object.
  bool IsOneLine() const
  {
    const std::size_t start = this->Text.find("): ");
    if (start == std::string::npos)
    {
      return false;
    }
    std::string message = this->Text.substr(start + 3);
    while (!message.empty() && message.back() == '\n')
    {
      message.pop_back();
    }
    return !message.empty() && message.find('\n') == std::string::npos;
  }
};

inline bool IsEmpty(vtkImageData* image)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  return image->GetPointData()->GetNumberOfArrays() == 0 && dimensions[0] * dimensions[1] == 0;
}

// Makes the reader read bytes, which must outlive it: from VTK's stream if it has one.
inline void SetBytes(vtkOpenEXRReader* reader, const std::vector<char>& bytes, std::size_t length)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  vtkNew<vtkMemoryResourceStream> stream;
  stream->SetBuffer(bytes.data(), length);
  reader->SetStream(stream);
#else
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(length));
#endif
}

// Updates the reader, which must fail with exactly one error of one of these codes.
inline void ExpectReadError(vtkOpenEXRReader* reader, const std::vector<unsigned long>& codes)
{
  vtkNew<Messages> messages;
  messages->Watch(reader);
  reader->Update();
  std::cout << messages->Text;
  EXR_CHECK(messages->Errors == 1);
  EXR_CHECK(messages->Warnings == 0);
  EXR_CHECK(messages->IsOneLine());
  EXR_CHECK(std::count(codes.begin(), codes.end(), reader->GetErrorCode()) == 1);
  EXR_CHECK(IsEmpty(reader->GetOutput()));
  reader->RemoveObserver(messages);
}

inline void ExpectReadError(vtkOpenEXRReader* reader, unsigned long code)
{
  ExpectReadError(reader, std::vector<unsigned long>{ code });
}

// Writes, which must fail with exactly one error of this code.
inline void ExpectWriteError(vtkOpenEXRWriter* writer, unsigned long code)
{
  vtkNew<Messages> messages;
  messages->Watch(writer);
  writer->Write();
  std::cout << messages->Text;
  EXR_CHECK(messages->Errors == 1);
  EXR_CHECK(messages->Warnings == 0);
  EXR_CHECK(messages->IsOneLine());
  EXR_CHECK(writer->GetErrorCode() == code);
  writer->RemoveObserver(messages);
}

inline vtkSmartPointer<vtkImageData> MakeImage(const std::vector<int>& extent, int components,
  int type = VTK_FLOAT, std::uint64_t seed = 1, float range = 100.0f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  image->AllocateScalars(type, components);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  Random random(seed);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      scalars->SetComponent(i, c, random.Value(range));
    }
  }
  return image;
}

// Writes, which must succeed.
inline void Write(vtkOpenEXRWriter* writer, const std::string& path)
{
  writer->SetFileName(path.c_str());
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
}

// Reads, which must succeed, also after a change of the file.
inline void Read(vtkOpenEXRReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  reader->Modified();
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
}

inline float* FloatData(vtkImageData* image)
{
  vtkFloatArray* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  return scalars ? scalars->GetPointer(0) : nullptr;
}

// Name of the channel of a component of the output.
inline std::string ComponentName(vtkOpenEXRReader* reader, int component)
{
  const char* name = reader->GetOutput()->GetPointData()->GetScalars()->GetComponentName(component);
  return name ? name : "";
}

// True for equal extents, components and bits.
inline bool SameBits(vtkImageData* a, vtkImageData* b)
{
  int extentA[6];
  int extentB[6];
  a->GetExtent(extentA);
  b->GetExtent(extentB);
  const float* dataA = FloatData(a);
  const float* dataB = FloatData(b);
  return dataA && dataB && std::equal(extentA, extentA + 6, extentB) &&
    a->GetNumberOfScalarComponents() == b->GetNumberOfScalarComponents() &&
    std::memcmp(dataA, dataB,
      sizeof(float) *
        static_cast<std::size_t>(a->GetPointData()->GetScalars()->GetNumberOfValues())) == 0;
}

inline std::vector<char> ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return std::vector<char>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

inline void WriteBytes(const std::string& path, const std::vector<char>& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline int CountFiles(const std::string& directory)
{
  return static_cast<int>(std::distance(
    std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
}

// Folder of the running test, with a slash at its end; empty at first.
inline std::string GetFolder()
{
  return vtkIndirectTest::GetArguments().at(0) + "/";
}
}

#endif

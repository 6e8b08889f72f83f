// SPDX-License-Identifier: BSD-3-Clause
// Damaged files: each must be read or reported as one error, without a crash. The mutations are the
// same on every run. ctest's timeout ends endless loops.

#include "OpenEXRLibraryFiles.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

using namespace exrtest;

namespace
{
// VTK_INDIRECT_FUZZ_MUTATIONS in the environment asks for a longer run.
constexpr int MutationsPerSeed = 400;

//------------------------------------------------------------------------------
std::vector<std::vector<char>> MakeSeeds(const std::string& folder)
{
  const std::string path = folder + "seed.exr";
  const imath::Box2i window = MakeWindow(-2, 21, 0, 39);
  std::vector<std::vector<char>> seeds;
  auto take = [&]() { seeds.push_back(ReadBytes(path)); };

  for (int compression = 0; compression < exr::NUM_COMPRESSION_METHODS; ++compression)
  {
    std::vector<Plane> planes;
    planes.emplace_back("R", compression % 2 ? exr::FLOAT : exr::HALF, window, 1);
    planes.emplace_back("G", exr::HALF, window, 2);
    planes.emplace_back("B", exr::HALF, window, 3);
    planes.emplace_back("id", exr::UINT, window, 4);
    WriteScanlines(path, window, planes, static_cast<exr::Compression>(compression));
    take();
  }
  for (exr::LevelMode mode : { exr::ONE_LEVEL, exr::MIPMAP_LEVELS, exr::RIPMAP_LEVELS })
  {
    std::vector<Plane> planes;
    planes.emplace_back("Y", exr::FLOAT, window, 5);
    planes.emplace_back("A", exr::HALF, window, 6);
    WriteTiles(path, window, planes,
      mode == exr::ONE_LEVEL ? exr::PIZ_COMPRESSION : exr::ZIP_COMPRESSION, 16, 16, mode);
    take();
  }
  std::vector<std::vector<Plane>> parts(2);
  parts[0].emplace_back("Y", exr::FLOAT, window, 7);
  parts[1].emplace_back("Z", exr::HALF, window, 8);
  WriteParts(path, window, parts);
  take();
  WriteDeep(path);
  take();
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 9, 0, 19, 0, 0 }, 4));
  writer->AddLayer("albedo", MakeImage({ 0, 9, 0, 19, 0, 0 }, 3));
  writer->SetFileName(path.c_str());
  writer->Write();
  take();
  return seeds;
}

//------------------------------------------------------------------------------
std::vector<char> Mutate(const std::vector<char>& seed, Random& random)
{
  std::vector<char> bytes = seed;
  auto position = [&]()
  {
    // Half of the time in the header and the table of chunks.
    const std::size_t size =
      random.Below(2) ? bytes.size() : std::min<std::size_t>(bytes.size(), 600);
    return static_cast<std::size_t>(random.Below(static_cast<std::uint32_t>(size)));
  };
  const std::uint32_t rounds = 1 + random.Below(3);
  for (std::uint32_t round = 0; round < rounds && bytes.size() > 8; ++round)
  {
    switch (random.Below(7))
    {
      case 0: // flip a bit
        bytes[position()] ^= static_cast<char>(1u << random.Below(8));
        break;
      case 1: // flip several bytes
        for (std::uint32_t i = 1 + random.Below(16); i > 0; --i)
        {
          bytes[position()] = static_cast<char>(random.Next());
        }
        break;
      case 2: // truncate
        bytes.resize(8 + position() % (bytes.size() - 8));
        break;
      case 3: // a block of random bytes
      {
        const std::size_t start = position();
        const std::size_t length =
          std::min<std::size_t>(1 + random.Below(64), bytes.size() - start);
        for (std::size_t i = 0; i < length; ++i)
        {
          bytes[start + i] = static_cast<char>(random.Next());
        }
        break;
      }
      case 4: // an interesting integer
      {
        static const std::uint32_t values[] = { 0u, 1u, 0xffffffffu, 0x7fffffffu, 0x80000000u,
          0x3fffffffu, 0x00010000u, 0x7f800000u };
        const std::size_t start = std::min(position(), bytes.size() - 4);
        const std::uint32_t value = values[random.Below(8)];
        std::memcpy(bytes.data() + start, &value, 4);
        break;
      }
      case 5: // remove a block
      {
        const std::size_t start = position();
        const std::size_t length =
          std::min<std::size_t>(1 + random.Below(32), bytes.size() - start);
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(start),
          bytes.begin() + static_cast<std::ptrdiff_t>(start + length));
        break;
      }
      default: // copy a block to elsewhere
      {
        const std::size_t from = position();
        const std::size_t to = position();
        const std::size_t length =
          std::min<std::size_t>(1 + random.Below(64), bytes.size() - std::max(from, to));
        const std::vector<char> block(bytes.begin() + static_cast<std::ptrdiff_t>(from),
          bytes.begin() + static_cast<std::ptrdiff_t>(from + length));
        std::copy(block.begin(), block.end(), bytes.begin() + static_cast<std::ptrdiff_t>(to));
        break;
      }
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Fuzz)
{
  const std::string folder = GetFolder();
  const std::vector<std::vector<char>> seeds = MakeSeeds(folder);
  const char* wanted = std::getenv("VTK_INDIRECT_FUZZ_MUTATIONS");
  const int mutationsPerSeed = wanted ? std::max(1, std::atoi(wanted)) : MutationsPerSeed;
  int mutations = 0;
  int readable = 0;
  double slowest = 0.0;
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    Random random(1000 + s);
    for (int i = 0; i < mutationsPerSeed; ++i)
    {
      const std::vector<char> bytes = Mutate(seeds[s], random);
      vtkNew<vtkOpenEXRReader> reader;
      vtkNew<Messages> messages;
      messages->Watch(reader);
      if (i % 10 == 0)
      {
        WriteBytes(folder + "mutation.exr", bytes);
        reader->SetFileName((folder + "mutation.exr").c_str());
      }
      else
      {
        SetBytes(reader, bytes, bytes.size());
      }
      reader->SetLayer(i % 3 == 0 && s + 1 == seeds.size() ? "albedo" : "");
      reader->SetMaximumSize(64);
      const auto start = std::chrono::steady_clock::now();
      reader->Update();
      const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      slowest = std::max(slowest, seconds);
      ++mutations;
      const bool failed = reader->GetErrorCode() != vtkErrorCode::NoError;
      const bool sound = messages->Errors == (failed ? 1 : 0) && messages->Warnings == 0 &&
        IsEmpty(reader->GetOutput()) == failed && (!failed || messages->IsOneLine());
      readable += failed ? 0 : 1;
      if (!sound)
      {
        std::cerr << "seed " << s << ", mutation " << i << ", " << seconds << " s, "
                  << messages->Errors << " error(s): " << messages->Text << "\n";
        EXR_CHECK(sound);
      }
    }
  }
  std::cout << seeds.size() << " seeds, " << mutations << " mutations, " << readable
            << " of them readable, slowest " << slowest << " s\n";
  EXR_CHECK(readable > 0 && readable < mutations);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Expected buffers: values of the same frame that were computed by the processor when the
// pack was made.
#ifndef CardExpected_h
#define CardExpected_h

#include "CardImages.h" // for Image

#include <nlohmann/json.hpp>

#include <string> // for names

class vtkIndirectIlluminationPass;

namespace card
{
struct Method;

/**
 * The buffers that a method's frame is checked by. Buffers that do not depend on the method are
 * checked with "automatic"; `window` is the picture, of eight bits a channel.
 */
std::vector<std::string> GetBufferNames(const Method& method);

/** Reads the values of a scene at a size, or begins with none where there is no file of them. */
class Expected
{
public:
  Expected(const std::string& folder, int width, int height);

  bool IsEmpty() const { return this->Values.empty(); }

  /** Keeps what a buffer holds, to be written. */
  void Record(const std::string& method, const std::string& buffer, const Image& image);
  /** Keeps the error of a method's irradiance against the path tracer, nRMSE R3. */
  void RecordError(const std::string& method, double error);
  void Write() const;

  /**
   * Compares a buffer with what was recorded. Returns {buffer, passed, worst, share, mean,
   * tolerance, allowed_share, why}; `bad` gets the places that differ.
   */
  nlohmann::json Check(const Method& method, const std::string& buffer, const Image& image,
    std::vector<std::array<int, 2>>& bad) const;

  /** Compares an error with what was recorded; returns the same. */
  nlohmann::json CheckError(const Method& method, double error) const;

private:
  std::string Path;
  nlohmann::json Values;
};
}

#endif

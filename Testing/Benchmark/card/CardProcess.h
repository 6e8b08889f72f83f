// SPDX-License-Identifier: BSD-3-Clause
// Programs run beside this one, because what a driver does to one must not end all.
#ifndef CardProcess_h
#define CardProcess_h

#include <functional> // for the watch
#include <string>     // for names
#include <vector>     // for arguments

namespace card
{
struct ProcessResult
{
  /** Empty when the program returned; otherwise how it ended, such as "signal 11". */
  std::string End;
  int Code = 0; // that it returned
};

/**
 * Runs a program until it ends. `watch` is called every few milliseconds; a text that is not empty
 * says why the program is to be killed, and becomes the End. With a log, the program's output goes
 * there, else where this one's goes. A program without a log is one that runs others: these end
 * with it, and all of them when this one is interrupted.
 */
ProcessResult RunProcess(const std::vector<std::string>& arguments, const std::string& log,
  const std::function<std::string()>& watch);

/** The last lines of a file, at most `count`. */
std::string ReadTail(const std::string& path, int count);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "CardProcess.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <fstream>
#include <thread>

extern char** environ;

namespace
{
// The group of processes that ends with this one.
volatile sig_atomic_t Group = 0;

void EndGroup(int signal)
{
  if (Group > 0)
  {
    kill(-Group, SIGKILL);
  }
  _exit(128 + signal);
}
}

//------------------------------------------------------------------------------
card::ProcessResult card::RunProcess(const std::vector<std::string>& arguments,
  const std::string& log, const std::function<std::string()>& watch)
{
  std::vector<char*> argv;
  for (const std::string& argument : arguments)
  {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!log.empty())
  {
    posix_spawn_file_actions_addopen(
      &actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  const bool leads = log.empty();
  if (leads)
  {
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    signal(SIGINT, EndGroup);
    signal(SIGTERM, EndGroup);
  }
  pid_t child = 0;
  const int error = posix_spawn(&child, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  Group = leads && error == 0 ? child : 0;
  ProcessResult result;
  if (error != 0)
  {
    result.End = arguments[0] + " cannot be run: " + std::strerror(error);
    return result;
  }
  for (;;)
  {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child)
    {
      if (WIFSIGNALED(status) && result.End.empty())
      {
        result.End = "signal " + std::to_string(WTERMSIG(status));
      }
      result.Code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
      return result;
    }
    if (ended < 0 && errno != EINTR)
    {
      result.End = std::string("lost: ") + std::strerror(errno);
      return result;
    }
    if (result.End.empty())
    {
      result.End = watch();
      if (!result.End.empty())
      {
        kill(leads ? -child : child, SIGKILL);
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

//------------------------------------------------------------------------------
std::string card::ReadTail(const std::string& path, int count)
{
  std::ifstream file(path);
  std::deque<std::string> lines;
  std::string line;
  while (std::getline(file, line))
  {
    lines.push_back(line);
    if (static_cast<int>(lines.size()) > count)
    {
      lines.pop_front();
    }
  }
  std::string text;
  for (const std::string& kept : lines)
  {
    text += (text.empty() ? "" : "\n") + kept;
  }
  return text;
}

// gpu: the program by which a pack is used. It starts a program of the pack on a system about which
// nothing is known: so it is linked statically, and asks neither for a shell nor for /proc or /dev.
//
// Two things are its work. It says in one line what the dynamic loader would say in many lines of
// names and versions. And it decides about libraries that the pack has and a driver of OpenGL may
// load, too: a process has only one libstdc++, and the driver's LLVM may need a newer one than the
// pack has. So the system's is taken when it has all versions of symbols that the programs ask for;
// otherwise the pack's, which is then the newer one.

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <elf.h>
#include <fcntl.h>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace
{
const char* const Loader = "/lib64/ld-linux-x86-64.so.2";

// Folders of a driver of NVIDIA's that was mounted into a container.
const std::string NvidiaLibraries = "/usr/local/nvidia/lib64";
const std::string NvidiaVendors = "/usr/local/nvidia/share/glvnd/egl_vendor.d";

void Say(const std::string& text)
{
  std::fprintf(stderr, "gpu: %s\n", text.c_str());
}

[[noreturn]] void Fail(const std::string& text)
{
  Say(text);
  std::exit(1);
}

bool IsFile(const std::string& path)
{
  struct stat status;
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

bool IsFolder(const std::string& path)
{
  struct stat status;
  return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

std::string Variable(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

// As the loader reads LD_LIBRARY_PATH: an empty name is the current folder.
std::vector<std::string> PathFolders(const std::string& path)
{
  std::vector<std::string> folders;
  if (path.empty())
  {
    return folders;
  }
  std::size_t begin = 0;
  while (begin <= path.size())
  {
    const std::size_t end = std::min(path.find_first_of(":;", begin), path.size());
    folders.push_back(end > begin ? path.substr(begin, end - begin) : ".");
    begin = end + 1;
  }
  return folders;
}

// A file's bytes. Whoever reads them asks whether they are there.
class MappedFile
{
public:
  explicit MappedFile(const std::string& path)
  {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status;
    if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0)
    {
      void* data =
        mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
      if (data != MAP_FAILED)
      {
        this->Data = static_cast<const char*>(data);
        this->Size = static_cast<std::size_t>(status.st_size);
      }
    }
    if (file >= 0)
    {
      close(file);
    }
  }
  ~MappedFile()
  {
    if (this->Data)
    {
      munmap(const_cast<char*>(this->Data), this->Size);
    }
  }
  MappedFile(const MappedFile&) = delete;
  void operator=(const MappedFile&) = delete;

  template <typename T>
  bool Read(std::size_t offset, T& value) const
  {
    if (offset > this->Size || this->Size - offset < sizeof(T))
    {
      return false;
    }
    std::memcpy(&value, this->Data + offset, sizeof(T));
    return true;
  }

  std::string Text(std::size_t offset) const
  {
    if (offset >= this->Size)
    {
      return "";
    }
    return std::string(this->Data + offset, strnlen(this->Data + offset, this->Size - offset));
  }

  std::size_t Find(const std::string& text) const
  {
    const char* end = this->Data + this->Size;
    const char* found = std::search(this->Data, end, text.begin(), text.end());
    return found == end ? std::string::npos : static_cast<std::size_t>(found - this->Data);
  }

private:
  const char* Data = nullptr;
  std::size_t Size = 0;
};

// Facts of a shared library, or nothing if the loader would pass over the file.
struct Library
{
  bool Valid = false;
  std::set<std::string> Versions; // those it defines
  std::set<std::string> Needed;

  explicit Library(const std::string& path)
  {
    const MappedFile file(path);
    Elf64_Ehdr header;
    if (!file.Read(0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_machine != EM_X86_64)
    {
      return;
    }
    std::vector<Elf64_Phdr> segments(header.e_phnum);
    Elf64_Phdr dynamic{};
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      if (!file.Read(header.e_phoff + i * sizeof(Elf64_Phdr), segments[i]))
      {
        return;
      }
      if (segments[i].p_type == PT_DYNAMIC)
      {
        dynamic = segments[i];
      }
    }
    const auto offsetOf = [&segments](Elf64_Addr address)
    {
      for (const Elf64_Phdr& segment : segments)
      {
        if (segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
          address - segment.p_vaddr < segment.p_filesz)
        {
          return address - segment.p_vaddr + segment.p_offset;
        }
      }
      return static_cast<Elf64_Addr>(-1);
    };

    Elf64_Addr texts = 0, definitions = 0;
    std::vector<Elf64_Xword> needed;
    Elf64_Dyn entry;
    for (Elf64_Xword at = 0;
         at < dynamic.p_filesz && file.Read(dynamic.p_offset + at, entry) && entry.d_tag != DT_NULL;
         at += sizeof(entry))
    {
      switch (entry.d_tag)
      {
        case DT_STRTAB:
          texts = entry.d_un.d_ptr;
          break;
        case DT_VERDEF:
          definitions = entry.d_un.d_ptr;
          break;
        case DT_NEEDED:
          needed.push_back(entry.d_un.d_val);
          break;
        default:
          break;
      }
    }
    texts = offsetOf(texts);
    for (Elf64_Xword name : needed)
    {
      this->Needed.insert(file.Text(texts + name));
    }
    bool more = definitions != 0;
    definitions = offsetOf(definitions);
    Elf64_Verdef definition;
    while (more && file.Read(definitions, definition))
    {
      Elf64_Verdaux name;
      if (file.Read(definitions + definition.vd_aux, name))
      {
        this->Versions.insert(file.Text(texts + name.vda_name));
      }
      more = definition.vd_next != 0;
      definitions += definition.vd_next;
    }
    this->Valid = true;
  }
};

// The file of ldconfig, in the form that glibc has written since 2.2. It begins anew at its mark,
// from which its offsets count; the older form may stand before it.
std::vector<std::string> Cached(const std::string& soname)
{
  std::vector<std::string> paths;
  const MappedFile cache("/etc/ld.so.cache");
  const std::string mark = "glibc-ld.so.cache1.1";
  struct
  {
    std::int32_t Flags;
    std::uint32_t Name, Path, Release;
    std::uint64_t Capabilities;
  } entry;
  const std::size_t begin = cache.Find(mark);
  std::uint32_t count = 0;
  if (begin == std::string::npos || !cache.Read(begin + mark.size(), count))
  {
    return paths;
  }
  const std::size_t headerSize = 48;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    if (!cache.Read(begin + headerSize + i * sizeof(entry), entry))
    {
      break;
    }
    if (cache.Text(begin + entry.Name) == soname)
    {
      paths.push_back(cache.Text(begin + entry.Path));
    }
  }
  return paths;
}

// The file that the loader would take of the system, or nothing.
std::string Find(const std::string& soname, const std::vector<std::string>& folders)
{
  std::vector<std::string> paths;
  for (const std::string& folder : folders)
  {
    paths.push_back(folder + "/" + soname);
  }
  const std::vector<std::string> cached = Cached(soname);
  paths.insert(paths.end(), cached.begin(), cached.end());
  for (const char* folder : { "/lib/x86_64-linux-gnu", "/usr/lib/x86_64-linux-gnu", "/lib64",
         "/usr/lib64", "/lib", "/usr/lib" })
  {
    paths.push_back(std::string(folder) + "/" + soname);
  }
  for (const std::string& path : paths)
  {
    if (IsFile(path) && Library(path).Valid)
    {
      return path;
    }
  }
  return "";
}

// The folder of the pack: where this program lies.
std::string PackFolder(const char* name)
{
  // The kernel hands over the name with which it was started, which is right where argv[0] is not.
  const auto started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  char resolved[PATH_MAX];
  for (const char* candidate : { started, name })
  {
    if (candidate && realpath(candidate, resolved) && IsFile(resolved))
    {
      const std::string path = resolved;
      const std::size_t slash = path.rfind('/');
      return slash == 0 ? "/" : path.substr(0, slash);
    }
  }
  Fail("its own folder cannot be found; start it by its path");
}

// 2.34 of GLIBC_2.34, as numbers that compare. Others, such as GLIBC_PRIVATE, are no release.
std::vector<int> Release(const std::string& version)
{
  std::vector<int> numbers;
  const std::string prefix = "GLIBC_";
  if (version.compare(0, prefix.size(), prefix) != 0)
  {
    return numbers;
  }
  std::istringstream stream(version.substr(prefix.size()));
  int number;
  while (stream >> number)
  {
    numbers.push_back(number);
    stream.ignore(1, '.');
  }
  return numbers;
}

std::string NewestRelease(const std::set<std::string>& versions)
{
  std::string newest;
  for (const std::string& version : versions)
  {
    if (Release(version) > Release(newest))
    {
      newest = version;
    }
  }
  return newest.empty() ? "unknown" : newest.substr(std::strlen("GLIBC_"));
}

bool HasVendorFile(const std::string& folder)
{
  bool found = false;
  if (DIR* entries = opendir(folder.c_str()))
  {
    while (const dirent* entry = readdir(entries))
    {
      const std::string name = entry->d_name;
      found = found || (name.size() > 5 && name.compare(name.size() - 5, 5, ".json") == 0);
    }
    closedir(entries);
  }
  return found;
}

class Launcher
{
public:
  explicit Launcher(const std::string& pack)
    : Pack(pack)
    , UserPath(Variable("LD_LIBRARY_PATH"))
    , Folders(PathFolders(this->UserPath))
  {
    if (pack.find_first_of(":;") != std::string::npos)
    {
      Fail(
        "the name of its folder has a colon or semicolon, of which the loader makes two: " + pack);
    }
    if (IsFolder(NvidiaLibraries) &&
      std::find(this->Folders.begin(), this->Folders.end(), NvidiaLibraries) == this->Folders.end())
    {
      this->Folders.push_back(NvidiaLibraries);
      this->UserPath += (this->UserPath.empty() ? "" : ":") + NvidiaLibraries;
    }
    this->Path.push_back(pack + "/lib");
  }

  // Decides about all that the programs ask of the system.
  void FindLibraries(bool print)
  {
    if (!IsFile(Loader))
    {
      Fail(std::string("no ") + Loader +
        ": the programs need a Linux for x86-64 with glibc (not musl, not 32 bits)");
    }
    const std::string name = this->Pack + "/lib/needs.txt";
    std::ifstream needs(name);
    std::string line;
    while (std::getline(needs, line))
    {
      std::istringstream words(line);
      std::string kind, soname, version;
      std::vector<std::string> versions;
      words >> kind >> soname;
      while (words >> version)
      {
        versions.push_back(version);
      }
      if (kind == "system")
      {
        this->System(soname, versions, print);
      }
      else if (kind == "either")
      {
        this->Either(soname, versions, print);
      }
    }
    if (!needs.eof())
    {
      Fail("cannot read " + name);
    }
  }

  void FindDriver(bool print)
  {
    const std::string library = Find("libEGL.so.1", this->Folders);
    // A libEGL of libglvnd's is no driver: it asks these files for one. Any other is its own.
    const bool dispatches = library.empty() || Library(library).Needed.count("libGLdispatch.so.0");
    const bool driver = !dispatches || this->FindVendor();
    if (library.empty() && !driver)
    {
      Fail("no libEGL.so.1: install the driver's EGL (Debian: libegl1)");
    }
    if (!driver)
    {
      // Perhaps this libEGL was built to look elsewhere.
      Say("no driver is named in /usr/share/glvnd/egl_vendor.d; if none is found, install its EGL "
          "(Debian: libegl-mesa0 or libegl-nvidia0)");
    }
    const std::string own = this->Pack + "/lib/glvnd";
    if (library.empty())
    {
      if (!IsFile(own + "/libEGL.so.1"))
      {
        Fail("no libEGL.so.1: install the driver's EGL (Debian: libegl1)");
      }
      Say("no libEGL.so.1 here; taking libglvnd's of the pack, which asks the driver");
      this->Path.push_back(own);
    }
    if (print)
    {
      std::printf("libEGL.so.1 %s\n", library.empty() ? "pack" : library.c_str());
    }
  }

  [[noreturn]] void Start(const std::string& program, char** words)
  {
    std::string path;
    for (const std::string& folder : this->Path)
    {
      path += (path.empty() ? "" : ":") + folder;
    }
    if (!this->UserPath.empty())
    {
      path += ":" + this->UserPath;
    }
    setenv("LD_LIBRARY_PATH", path.c_str(), 1);
    setenv("VTK_INDIRECT_PACK", this->Pack.c_str(), 1);
    words[0] = const_cast<char*>(program.c_str());
    execv(program.c_str(), words);
    Fail("cannot start " + program + ": " + std::strerror(errno));
  }

private:
  void System(const std::string& soname, const std::vector<std::string>& versions, bool print)
  {
    const std::string path = Find(soname, this->Folders);
    if (path.empty())
    {
      Fail("no " + soname + ": it is a part of glibc (Debian: libc6)");
    }
    const Library library(path);
    std::set<std::string> missing;
    for (const std::string& version : versions)
    {
      if (!library.Versions.count(version))
      {
        missing.insert(version);
      }
    }
    if (!missing.empty())
    {
      Fail("glibc " + NewestRelease(missing) + " or later is needed; the newest version in " +
        path + " is " + NewestRelease(library.Versions));
    }
    if (print)
    {
      std::printf("%s %s\n", soname.c_str(), path.c_str());
    }
  }

  void Either(const std::string& soname, const std::vector<std::string>& versions, bool print)
  {
    std::string path = Find(soname, this->Folders);
    if (!path.empty())
    {
      const Library library(path);
      for (const std::string& version : versions)
      {
        if (!library.Versions.count(version))
        {
          path.clear();
          break;
        }
      }
    }
    if (path.empty())
    {
      this->Path.push_back(this->Pack + "/lib/either/" + soname);
    }
    if (print)
    {
      std::printf("%s %s\n", soname.c_str(), path.empty() ? "pack" : path.c_str());
    }
  }

  // True if libglvnd finds a driver, perhaps with help.
  bool FindVendor()
  {
    const char* const variable = "__EGL_VENDOR_LIBRARY_FILENAMES";
    if (!Variable(variable).empty() || !Variable("__EGL_VENDOR_LIBRARY_DIRS").empty() ||
      HasVendorFile("/etc/glvnd/egl_vendor.d") || HasVendorFile("/usr/share/glvnd/egl_vendor.d"))
    {
      return true;
    }
    // A container often gets the driver's libraries without the file that names them.
    for (const std::string& file :
      { NvidiaVendors + "/10_nvidia.json", this->Pack + "/lib/glvnd/10_nvidia.json" })
    {
      if (IsFile(file) && !Find("libEGL_nvidia.so.0", this->Folders).empty())
      {
        Say("no file in /usr/share/glvnd/egl_vendor.d; taking " + file);
        setenv(variable, file.c_str(), 1);
        return true;
      }
    }
    return false;
  }

  const std::string Pack;
  std::string UserPath;
  std::vector<std::string> Folders; // where the system's libraries are looked for first
  std::vector<std::string> Path;
};
}

int main(int argc, char** argv)
{
  if (argc < 1)
  {
    return 1;
  }
  const std::string pack = PackFolder(argv[0]);
  const std::string word = argc > 1 ? argv[1] : "";
  Launcher launcher(pack);
  if (word == "libraries")
  {
    launcher.FindLibraries(true);
    launcher.FindDriver(true);
    return 0;
  }
  if (word == "exec" && argc < 3)
  {
    std::fprintf(stderr, "usage: gpu exec PROGRAM [ARGUMENTS], PROGRAM being one of bin/\n");
    return 2;
  }
  const std::string program = pack + "/bin/" + (word == "exec" ? argv[2] : "IndirectCardBenchmark");
  if (!IsFile(program))
  {
    Fail("no program " + program);
  }
  launcher.FindLibraries(false);
  launcher.FindDriver(false);
  launcher.Start(program, word == "exec" ? argv + 2 : argv);
}

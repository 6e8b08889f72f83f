/* Functions that Debian's libstdc++, libgcc_s, libexpat and others need of a glibc newer than 2.34, for
 * systems that have none: arc4random and its kin came with 2.36, _dl_find_object with 2.35.
 *
 * The packed copies of such libraries ask for these functions under GLIBC_2.2.5, a version that
 * each glibc for x86-64 has; no glibc has these functions under it, and this library does. So all
 * others go on with those of their glibc, if it has them.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <link.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

void arc4random_buf(void* buffer, size_t size)
{
  unsigned char* at = buffer;
  while (size > 0)
  {
    const ssize_t got = getrandom(at, size, 0);
    if (got > 0)
    {
      at += got;
      size -= (size_t)got;
    }
    else if (errno != EINTR)
    {
      abort(); /* as that of glibc: nobody checks */
    }
  }
}

uint32_t arc4random(void)
{
  uint32_t value;
  arc4random_buf(&value, sizeof(value));
  return value;
}

uint32_t arc4random_uniform(uint32_t bound)
{
  if (bound < 2)
  {
    return 0;
  }
  /* 2^32 modulo the bound: below it, the first of the residues would come more often. */
  const uint32_t least = -bound % bound;
  uint32_t value;
  do
  {
    value = arc4random();
  } while (value < least);
  return value % bound;
}

/* As <dlfcn.h> of glibc 2.35 has it, for x86-64. */
struct found_object
{
  unsigned long long flags;
  void* begin;
  void* end;
  struct link_map* map;
  void* eh_frame;
  unsigned long long reserved[7];
};

struct search
{
  uintptr_t address;
  struct found_object* found;
  int status;
};

static int look(struct dl_phdr_info* info, size_t size, void* data)
{
  (void)size;
  struct search* search = data;
  uintptr_t begin = UINTPTR_MAX, end = 0;
  void* eh_frame = NULL;
  int inside = 0;
  for (int i = 0; i < info->dlpi_phnum; ++i)
  {
    const ElfW(Phdr)* segment = &info->dlpi_phdr[i];
    const uintptr_t at = info->dlpi_addr + segment->p_vaddr;
    if (segment->p_type == PT_LOAD)
    {
      begin = at < begin ? at : begin;
      end = at + segment->p_memsz > end ? at + segment->p_memsz : end;
      inside |= search->address >= at && search->address - at < segment->p_memsz;
    }
    else if (segment->p_type == PT_GNU_EH_FRAME)
    {
      eh_frame = (void*)at;
    }
  }
  if (!inside)
  {
    return 0;
  }
  search->found->begin = (void*)begin;
  search->found->end = (void*)end;
  search->found->eh_frame = eh_frame;
  search->status = 0;
  return 1;
}

/* Finds the table by which exceptions are unwound. glibc's own function does not lock; this is slower.
 * The map of the object is not given: libgcc, which alone calls this, does not read it. */
int find_object(void* address, struct found_object* found) __asm__("_dl_find_object");

int find_object(void* address, struct found_object* found)
{
  struct search search = { (uintptr_t)address, found, -1 };
  memset(found, 0, sizeof(*found));
  dl_iterate_phdr(look, &search);
  return search.status;
}

// Preloaded into a program: a disk that fails late. FAILING_CALL names what fails: fsync, close or rename.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace {

bool fails(const char* call) {
  const char* failing = std::getenv("FAILING_CALL");
  return failing && std::strcmp(failing, call) == 0;
}

int failure(int error) {
  errno = error;
  return -1;
}

}  // namespace

extern "C" {

int fsync(int descriptor) {
  if (fails("fsync")) return failure(EIO);
  return reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"))(descriptor);
}

/** Of regular files that were written to. */
int close(int descriptor) {
  struct stat status;
  const bool written = fails("close") && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                       status.st_size > 0 && (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
  const int result = reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "close"))(descriptor);
  return written ? failure(EDQUOT) : result;
}

int rename(const char* from, const char* to) noexcept {
  if (fails("rename")) return failure(EACCES);
  return reinterpret_cast<int (*)(const char*, const char*)>(dlsym(RTLD_NEXT, "rename"))(from, to);
}

}  // extern "C"

#include "text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "poinsot/scene/reader.h"

namespace poinsot::scene {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& found) {
  throw Error(path + ": " + found + "; expected a regular file of at most " + std::to_string(kLargestTextFile) +
              " bytes");
}

[[noreturn]] void refuseUnreadable(const std::string& path, int error) {
  refuse(path, std::string("cannot be read, ") + std::strerror(error));
}

std::string kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "is a directory";
  if (S_ISFIFO(mode)) return "is a FIFO (named pipe)";
  if (S_ISCHR(mode)) return "is a character device";
  if (S_ISBLK(mode)) return "is a block device";
  return "is not a regular file";
}

class Descriptor {
 public:
  // Without O_NONBLOCK opening a FIFO waits for a writer.
  explicit Descriptor(const std::string& path)
      : value_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
    if (value_ < 0) refuseUnreadable(path, errno);
  }
  ~Descriptor() { close(value_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int value() const { return value_; }

 private:
  int value_;
};

}  // namespace

std::string readTextFile(const std::string& path) {
  const Descriptor file(path);
  // What was opened is asked, not the path, which may lead elsewhere by now.
  struct stat status;
  if (fstat(file.value(), &status) != 0) refuseUnreadable(path, errno);
  if (!S_ISREG(status.st_mode)) refuse(path, kindOf(status.st_mode));
  if (status.st_size > static_cast<off_t>(kLargestTextFile)) {
    refuse(path, "has " + std::to_string(status.st_size) + " bytes");
  }
  std::string text;
  char buffer[65536];
  while (true) {
    const ssize_t count = read(file.value(), buffer, sizeof buffer);
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuseUnreadable(path, errno);
    text.append(buffer, static_cast<std::size_t>(count));
    // It has grown since it was asked, or is one of those of /proc, which all say 0.
    if (text.size() > kLargestTextFile) refuse(path, "has more than " + std::to_string(kLargestTextFile) + " bytes");
  }
}

}  // namespace poinsot::scene

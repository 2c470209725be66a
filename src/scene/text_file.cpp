#include "text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "poinsot/scene/message.h"
#include "poinsot/scene/reader.h"

namespace poinsot::scene {
namespace {

/** Returns words with the absolute path that a relative one stands for; empty for an absolute one. */
std::string whereItIs(const std::string& path) {
  if (path.empty() || path.front() == '/') return "";
  std::error_code failed;
  const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
  return failed ? "" : "the relative path means " + absolute.string();
}

[[noreturn]] void refuse(const std::string& path, const std::string& found) {
  throw Error(
      path + ": " +
      expectedGot("a regular file of at most " + std::to_string(kLargestTextFile) + " bytes", found, whereItIs(path)));
}

[[noreturn]] void refuseUnreadable(const std::string& path, int error) {
  refuse(path, std::string("none that can be read: ") + std::strerror(error));
}

std::string kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a FIFO (named pipe)";
  if (S_ISCHR(mode)) return "a character device";
  if (S_ISBLK(mode)) return "a block device";
  return "another kind of file";
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
  // Asks about the file that was opened; the path may lead elsewhere by now.
  struct stat status;
  if (fstat(file.value(), &status) != 0) refuseUnreadable(path, errno);
  if (!S_ISREG(status.st_mode)) refuse(path, kindOf(status.st_mode));
  if (status.st_size > static_cast<off_t>(kLargestTextFile)) {
    refuse(path, std::to_string(status.st_size) + " bytes");
  }
  std::string text;
  char buffer[65536];
  while (true) {
    const ssize_t count = read(file.value(), buffer, sizeof buffer);
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuseUnreadable(path, errno);
    text.append(buffer, static_cast<std::size_t>(count));
    // It has grown since fstat, or is a file of /proc, which all claim to have 0 bytes.
    if (text.size() > kLargestTextFile) refuse(path, "a larger one");
  }
}

}  // namespace poinsot::scene

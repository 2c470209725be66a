#include "output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

namespace poinsot::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFiles = 4;
constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP};

/** Paths of existing temporary files; empty slots are free. Plain memory, because a signal handler reads it. */
char temporaries[kMostFiles][PATH_MAX];

extern "C" void removeAndEnd(int signal) {
  for (const char* path : temporaries) {
    if (path[0]) unlink(path);
  }
  raise(signal);  // the handler has been reset, so that the signal ends the process
}

/** Blocks the signals that would end the process, as long as it lives. */
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : kEndingSignals) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/** Call with signals held. */
void note(const std::string& path) {
  for (char* slot : temporaries) {
    if (slot[0]) continue;
    std::strncpy(slot, path.c_str(), PATH_MAX - 1);
    return;
  }
}
void forget(const std::string& path) {
  for (char* slot : temporaries) {
    if (path == slot) slot[0] = 0;
  }
}

[[noreturn]] void refuse(const std::string& path) {
  throw OutputError(path, std::strerror(errno));
}

/** Returns the path of the file behind symbolic links, or the path itself where there is no file yet. */
std::string followed(const std::string& path) {
  std::error_code none;
  const fs::path real = fs::canonical(path, none);
  return none ? path : real.string();
}

}  // namespace

OutputFile::OutputFile(const std::string& path, Kind kind) : path_(path), target_(followed(path)) {
  struct stat existing;
  if (stat(target_.c_str(), &existing) == 0) {
    if (S_ISDIR(existing.st_mode)) throw OutputError(path_, std::strerror(EISDIR));
    if (!S_ISREG(existing.st_mode)) {
      if (kind == Kind::regular_only) throw OutputError(path_, "expected a regular file, got another kind of file");
      descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
      if (descriptor_ < 0) refuse(path_);
      return;
    }
    if (access(target_.c_str(), W_OK) != 0) refuse(path_);
    createTemporary();
    fchmod(descriptor_, existing.st_mode & 07777);
  } else {
    createTemporary();
  }
}

void OutputFile::createTemporary() {
  const fs::path target(target_);
  const std::string name = (target.parent_path() / ("." + target.filename().string() + ".")).string();
  const SignalsHeld held;
  for (int i = 0; descriptor_ < 0; ++i) {
    temporary_ = name + std::to_string(getpid()) + (i > 0 ? "-" + std::to_string(i) : "") + ".tmp";
    descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) {
      temporary_.clear();
      refuse(path_);
    }
  }
  note(temporary_);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (temporary_.empty()) return;
  const SignalsHeld held;
  unlink(temporary_.c_str());
  forget(temporary_);
}

void OutputFile::bringToDisk() {
  if (!temporary_.empty() && fsync(descriptor_) != 0) refuse(path_);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) refuse(path_);
}

void OutputFile::rename() {
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) refuse(path_);
  forget(temporary_);
  temporary_.clear();
  // The name is on the disk once its directory is. Some file systems do not offer that.
  const std::string directory = fs::path(target_).parent_path().string();
  const int descriptor = open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

void OutputFile::commit(const std::vector<OutputFile*>& files) {
  for (OutputFile* file : files) file->bringToDisk();
  const SignalsHeld held;
  for (OutputFile* file : files) file->rename();
}

void OutputFile::catchSignals() {
  struct sigaction ending = {}, before;
  ending.sa_handler = removeAndEnd;
  ending.sa_flags = SA_RESETHAND;
  sigemptyset(&ending.sa_mask);
  for (const int signal : kEndingSignals) {
    // A signal that is ignored from the start, as under nohup, stays ignored.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &ending, nullptr);
  }
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

void TextSink::flush() {
  const char* next = text_.data();
  for (std::size_t left = text_.size(); left > 0;) {
    const ssize_t written = write(descriptor_, next, left);
    if (written < 0) {
      if (errno == EINTR) continue;
      throw OutputError(name_, std::strerror(errno));
    }
    next += written;
    left -= static_cast<std::size_t>(written);
  }
  text_.clear();
}

}  // namespace poinsot::tools

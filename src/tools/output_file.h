#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace poinsot::tools {

/** Output that cannot be written; what() names the file and the reason. */
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& file, const std::string& reason)
      : std::runtime_error("cannot write " + file + ": " + reason) {}
};

/**
 * A file that comes whole or not at all. It is written under a temporary name beside its own, .NAME.PID.tmp; commit()
 * brings it to the disk and gives it its name. Without commit() it is removed with its object, and also when SIGINT,
 * SIGTERM or SIGHUP end the process (after catchSignals()). What stood under the name before stays until then.
 *
 * What is no regular file (a terminal, a pipe, /dev/full) is written to directly, where that is allowed.
 */
class OutputFile {
 public:
  enum class Kind { regular_only, any };

  /** @param path a symbolic link is followed. Throws OutputError. */
  OutputFile(const std::string& path, Kind kind);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /** As it was given. */
  const std::string& path() const { return path_; }
  /** Where to write. */
  const std::string& writePath() const { return temporary_.empty() ? target_ : temporary_; }
  int descriptor() const { return descriptor_; }

  /** Gives all of them their names, once all are on the disk. Throws OutputError. */
  static void commit(const std::vector<OutputFile*>& files);

  /** From now on signals that end the process remove temporary files; a closed pipe or a limit is a write error. */
  static void catchSignals();

 private:
  void createTemporary();
  void bringToDisk();
  void rename();

  std::string path_, target_, temporary_;
  int descriptor_ = -1;
};

/** Buffers text on its way to a descriptor. */
class TextSink {
 public:
  TextSink(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}

  /** What is appended here is written when it is enough; see pour(). */
  std::string& text() { return text_; }

  /** Writes when much has gathered. Throws OutputError. */
  void pour() {
    if (text_.size() >= kMuch) flush();
  }
  /** Throws OutputError. */
  void flush();

 private:
  static constexpr std::size_t kMuch = 1 << 16;

  int descriptor_;
  std::string name_;
  std::string text_;
};

}  // namespace poinsot::tools

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace poinsot::tools {

/** A failure to write output; what() names the file and the reason. */
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& file, const std::string& reason)
      : std::runtime_error("cannot write " + file + ": " + reason) {}
};

/**
 * A file that is written whole or not at all. It has a temporary name beside its own, .NAME.PID.tmp, until commit()
 * brings it to the disk and gives it its name; an earlier file of that name stays until then. Without commit() the
 * destructor removes it, and so do SIGINT, SIGTERM and SIGHUP when they end the process (after catchSignals()).
 *
 * Anything but a regular file (a terminal, a pipe, /dev/full) is written to directly, where that is allowed.
 */
class OutputFile {
 public:
  enum class Kind { regular_only, any };

  /** @param path a symbolic link is followed. Throws OutputError. */
  OutputFile(const std::string& path, Kind kind);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /** Returns the path as it was given. */
  const std::string& path() const { return path_; }
  /** Returns the path to write to. */
  const std::string& writePath() const { return temporary_.empty() ? target_ : temporary_; }
  int descriptor() const { return descriptor_; }

  /** Gives all of them their names, once all are on the disk. Throws OutputError. */
  static void commit(const std::vector<OutputFile*>& files);

  /** Makes signals that end the process remove temporary files, and a closed pipe or a size limit a write error. */
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

  /** Returns the buffer to append to; pour() and flush() write it. */
  std::string& text() { return text_; }

  /** Writes the buffer once it is large. Throws OutputError. */
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

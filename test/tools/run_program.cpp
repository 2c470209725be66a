#include "run_program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace poinsot {
namespace {

/** A file that is gone with its object. */
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content = "") {
    const int descriptor = mkstemp(path_);
    if (descriptor < 0) throw std::runtime_error("no temporary file");
    close(descriptor);
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { unlink(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_; }
  std::string content() const {
    std::ostringstream out;
    out << std::ifstream(path_, std::ios::binary).rdbuf();
    return out.str();
  }

 private:
  char path_[32] = "/tmp/poinsot_test_XXXXXX";
};

}  // namespace

std::string shellWord(const std::string& path) {
  return '"' + path + '"';
}

Outcome runProgram(const std::string& command_line, const std::string& input) {
  const TemporaryFile in(input), out, err;
  const int status =
      std::system(("{ " + command_line + " ; } < " + in.path() + " > " + out.path() + " 2> " + err.path()).c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, out.content(), err.content()};
}

}  // namespace poinsot

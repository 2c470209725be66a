// What the sanitizers must catch, so that it shows that they are there. The argument says which misuse.
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

namespace {

/** Keeps the compiler from seeing what is going to happen. */
int opaque(int value) {
  volatile int kept = value;
  return kept;
}

/** Two threads count in one place, and nothing keeps them apart. */
int raced() {
  int count = 0;
  const auto count_on = [&] {
    for (int i = 0; i < 1000; ++i) count = opaque(count) + 1;
  };
  std::thread one(count_on), other(count_on);
  one.join();
  other.join();
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  const char* const misuse = argc == 2 ? argv[1] : "";
  int result = 0;
  if (std::strcmp(misuse, "out_of_bounds") == 0) {
    const std::vector<int> three(3);
    result = three.data()[opaque(3)];
  } else if (std::strcmp(misuse, "overflow") == 0) {
    result = std::numeric_limits<int>::max() - opaque(0) + opaque(1);
  } else if (std::strcmp(misuse, "race") == 0) {
    result = raced();
  } else if (std::strcmp(misuse, "none") != 0) {
    return 2;
  }
  std::printf("nothing was caught, %d\n", opaque(result));
  return 0;
}

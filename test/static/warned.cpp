// A program with a warning, for clang_build.sh: it must not compile where warnings are errors.
int main() {
  int unused = 0;
}

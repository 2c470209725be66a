// The addresses of meshes, as RViz takes them.
#include <gtest/gtest.h>

#include "poinsot/ros/markers/meshes.h"

namespace poinsot::node {
namespace {

TEST(MeshAddress, isTheScenesOwnWhereThePathHasNoBlank) {
  for (const char* mesh : {"package://roscpp/a.dae", "package://nosuch/book.dae", "file:///a/b%20c.stl"}) {
    EXPECT_EQ(meshAddress(mesh), mesh);
  }
}

TEST(MeshAddress, ofAPathWithABlankIsEscaped) {
  EXPECT_EQ(meshAddress("file:///a b/c d%.stl"), "file:///a%20b/c%20d%25.stl");
}

}  // namespace
}  // namespace poinsot::node

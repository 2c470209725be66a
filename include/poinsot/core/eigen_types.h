#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/**
 * The fixed-size types of Eigen that public structs and signatures may have. Eigen aligns its own types whose size is a
 * multiple of 16 bytes (Quaterniond, Vector4d, Matrix2d, …) as the compiler's flags say, to 16, 32 or 64 bytes: a
 * struct with such a member has one layout in this library and another in a program that is compiled with -mavx2. These
 * are laid out like plain doubles under every flag, and convert to and from Eigen's own without being asked to.
 *
 * Vector3d and Matrix3d, of 24 and 72 bytes, are never aligned: they stand in public types as they are. Matrices of
 * dynamic size do not: what one side allocates the other could not release, because Eigen's allocator depends on the
 * flags too.
 */
namespace poinsot {

/** A quaternion whose layout does not depend on the compiler's flags. */
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;
/** A vector of four whose layout does not depend on the compiler's flags. */
using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

static_assert(alignof(Quaternion) == alignof(double) && sizeof(Quaternion) == 4 * sizeof(double), "as plain doubles");
static_assert(alignof(Vector4) == alignof(double) && sizeof(Vector4) == 4 * sizeof(double), "as plain doubles");
static_assert(alignof(Eigen::Vector3d) == alignof(double) && sizeof(Eigen::Vector3d) == 3 * sizeof(double),
              "as plain doubles");
static_assert(alignof(Eigen::Matrix3d) == alignof(double) && sizeof(Eigen::Matrix3d) == 9 * sizeof(double),
              "as plain doubles");

}  // namespace poinsot

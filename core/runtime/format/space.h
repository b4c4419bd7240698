// SPDX-License-Identifier: MIT
// Vectors and rotations in double precision, for forward and inverse kinematics.
#pragma once

#include <cmath>

namespace mocapress::runtime {

struct Vector3 {
  double at[3] = {};

  double& operator[](int i) { return at[i]; }
  double operator[](int i) const { return at[i]; }
};

inline Vector3 vector_of(const float* from) {
  return {
      {static_cast<double>(from[0]), static_cast<double>(from[1]), static_cast<double>(from[2])}};
}

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
inline double norm(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

/// A rotation or any other linear map.
struct Matrix3 {
  double at[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // row, column

  double& operator()(int row, int column) { return at[row][column]; }
  double operator()(int row, int column) const { return at[row][column]; }
  Vector3 column(int c) const { return {{at[0][c], at[1][c], at[2][c]}}; }
};

inline Vector3 operator*(const Matrix3& m, const Vector3& v) {
  return {{m(0, 0) * v[0] + m(0, 1) * v[1] + m(0, 2) * v[2],
           m(1, 0) * v[0] + m(1, 1) * v[1] + m(1, 2) * v[2],
           m(2, 0) * v[0] + m(2, 1) * v[1] + m(2, 2) * v[2]}};
}

inline Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return product;
}

/// a * transpose(b)
inline Matrix3 times_transposed(const Matrix3& a, const Matrix3& b) {
  Matrix3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product(i, j) = a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
  return product;
}

inline Matrix3 transposed(const Matrix3& m) {
  return times_transposed(Matrix3(), m);
}

/// The rotation of a unit quaternion.
inline Matrix3 rotation_of(double w, double x, double y, double z) {
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// The unit quaternion w x y z of a rotation, w >= 0.
inline void quaternion_of(const Matrix3& m, double* wxyz) {
  // Starts from the largest component, so that no division is by a small number.
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  int largest = 0;
  double most = trace;
  for (int i = 0; i < 3; ++i)
    if (m(i, i) > most) {
      most = m(i, i);
      largest = i + 1;
    }
  if (largest == 0) {
    const double root = std::sqrt(1 + trace);
    wxyz[0] = 0.5 * root;
    wxyz[1] = 0.5 / root * (m(2, 1) - m(1, 2));
    wxyz[2] = 0.5 / root * (m(0, 2) - m(2, 0));
    wxyz[3] = 0.5 / root * (m(1, 0) - m(0, 1));
  } else {
    const int i = largest - 1;
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double root = std::sqrt(1 + m(i, i) - m(j, j) - m(k, k));
    wxyz[0] = 0.5 / root * (m(k, j) - m(j, k));
    wxyz[1 + i] = 0.5 * root;
    wxyz[1 + j] = 0.5 / root * (m(j, i) + m(i, j));
    wxyz[1 + k] = 0.5 / root * (m(k, i) + m(i, k));
  }
  if (wxyz[0] < 0)
    for (int i = 0; i < 4; ++i) wxyz[i] = -wxyz[i];
}

}  // namespace mocapress::runtime

#pragma once

#include <QImage>
#include <ostream>

/** What a picture is made of. Shares are of all its pixels, from 0 to 1. */
struct Shares {
  double orange = 0;     ///< energy ellipsoid
  double blue = 0;       ///< momentum ellipsoid
  double seam = 0;       ///< white with orange and blue close by: the polhode, along which the ellipsoids meet
  double commonest = 0;  ///< of the one colour that most pixels have
  double cut = 0;        ///< of the pixels on the picture's edge, those that are orange or blue
};

Shares sharesOf(const QImage& picture);

/** The share of pixels that are not the same in both pictures. */
double changed(const QImage& before, const QImage& after);

std::ostream& operator<<(std::ostream& out, const Shares& shares);

#include "picture.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>
#include <vector>

namespace {

// Hues of the two ellipsoids [degrees]. Light changes how bright a surface is, hardly its hue: 242, 158, 13 is at 38
// and 26, 107, 204 at 213. Nothing else in the pictures is near either and as saturated.
constexpr int kOrangeHue = 38;
constexpr int kBlueHue = 213;
constexpr int kHueTolerance = 9;
constexpr int kLeastSaturation = 150;  // of 255
constexpr int kLeastValue = 50;        // of 255
constexpr int kWhite = 250;            // each channel at least; labels are darker
constexpr int kSeamReach = 12;         // pixels

bool isOfHue(const QColor& colour, int hue) {
  return std::abs(colour.hue() - hue) <= kHueTolerance && colour.saturation() >= kLeastSaturation &&
         colour.value() >= kLeastValue;
}

/** Which pixels have some property. */
class Mask {
 public:
  Mask(int width, int height) : width_(width), height_(height), bits_(width * height, false) {}

  void set(int x, int y) { bits_[y * width_ + x] = true; }

  bool near(int x, int y) const {
    for (int v = std::max(0, y - kSeamReach); v <= std::min(height_ - 1, y + kSeamReach); ++v) {
      for (int u = std::max(0, x - kSeamReach); u <= std::min(width_ - 1, x + kSeamReach); ++u) {
        if (bits_[v * width_ + u]) return true;
      }
    }
    return false;
  }

  bool at(int x, int y) const { return bits_[y * width_ + x]; }
  double share() const {
    return static_cast<double>(std::count(bits_.begin(), bits_.end(), true)) / static_cast<double>(bits_.size());
  }

 private:
  int width_, height_;
  std::vector<bool> bits_;
};

}  // namespace

Shares sharesOf(const QImage& picture) {
  const int width = picture.width(), height = picture.height();
  Mask orange(width, height), blue(width, height), white(width, height), seam(width, height);
  std::unordered_map<QRgb, int> counts;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const QColor colour = picture.pixelColor(x, y);
      ++counts[colour.rgb()];
      if (isOfHue(colour, kOrangeHue)) orange.set(x, y);
      if (isOfHue(colour, kBlueHue)) blue.set(x, y);
      if (std::min({colour.red(), colour.green(), colour.blue()}) >= kWhite) white.set(x, y);
    }
  }
  int edge = 0, cut = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x == 0 || y == 0 || x == width - 1 || y == height - 1) {
        ++edge;
        cut += orange.at(x, y) || blue.at(x, y);
      }
      if (white.at(x, y) && orange.near(x, y) && blue.near(x, y)) seam.set(x, y);
    }
  }
  Shares shares;
  shares.orange = orange.share();
  shares.blue = blue.share();
  shares.seam = seam.share();
  shares.cut = static_cast<double>(cut) / edge;
  for (const auto& [colour, count] : counts) {
    shares.commonest = std::max(shares.commonest, static_cast<double>(count) / (width * height));
  }
  return shares;
}

double changed(const QImage& before, const QImage& after) {
  int count = 0;
  for (int y = 0; y < before.height(); ++y) {
    for (int x = 0; x < before.width(); ++x) count += before.pixel(x, y) != after.pixel(x, y);
  }
  return static_cast<double>(count) / (before.width() * before.height());
}

std::ostream& operator<<(std::ostream& out, const Shares& shares) {
  return out << "orange " << 100 * shares.orange << " %, blue " << 100 * shares.blue << " %, white where they meet "
             << 100 * shares.seam << " %, commonest colour " << 100 * shares.commonest << " %, cut off by the edge "
             << 100 * shares.cut << " %";
}

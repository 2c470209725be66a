#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/view/flips.h"

namespace poinsot::node::parts {
namespace {

constexpr session::Nanoseconds kFiguresPause = session::kSecond / 4;  // slow enough to be read
constexpr session::Nanoseconds kFlipsPause = session::kSecond / 10;
constexpr double kPlainDrift = 1e-3;  // from here on, the ratio of the energies itself can be read

std::string methodOf(const MotionSetup& setup) {
  if (!setup.step) return setup.method;
  return setup.method +
         (*setup.step < 1 ? formatted(", step %.3g ms", 1e3 * *setup.step) : formatted(", step %.3g s", *setup.step));
}

std::string flipsInWords(const view::Flips& flips, bool only_one) {
  const bool next = std::isfinite(flips.to_next);
  const std::string when = next ? formatted("in %.1f s", flips.to_next) : "";
  if (only_one)
    return next ? "its only flip " + when : flips.since_start != 0 ? "flip 1, its only one" : "no flip to come";
  const std::string next_words = next ? "next flip " + when : "";
  if (flips.since_start == 0) return next_words;
  return formatted("flip %.0f", static_cast<double>(flips.since_start)) + ", next " + when;
}

/** Under torques there is nothing to compare with, and the energy is meant to change. */
std::string comparisonInWords(const Figures& figures) {
  if (std::isnan(figures.attitude_error)) return formatted("\nenergy %.4g J", figures.kinetic_energy);
  return formatted("\nerror %.1e rad", figures.attitude_error) +
         (std::abs(figures.energy_drift) < kPlainDrift ? formatted("\nE/E0 = 1 %+.1e", figures.energy_drift)
                                                       : formatted("\nE/E0 = %.4f", 1 + figures.energy_drift));
}

/** @param depth below the title [heights of letters]. */
Marker labelOf(const Subject& subject, LabelId id, double depth, const std::string& words, double height) {
  const Eigen::Vector3d place = subject.belowTitle(subject.frame.place.title, 0, depth);
  return subject.factory.text(id, names::kWorld, place, words, height);
}

class Words : public Part {
 public:
  Words(const Subject& subject, const MotionSetup& setup)
      : method_(methodOf(setup)), may_flip_(subject.closed_form && view::flipsOf(*subject.closed_form, 0, 1).flips) {}

  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    // Another method's flips are not those of the closed form.
    if (!may_flip_ || !now.motion.inClosedForm()) return;
    if (now.tick.time_rate != 0) direction_ = now.tick.time_rate;
    if (!flips_cadence_.due(now.tick.stamp)) return;
    flips_ = flipsInWords(view::flipsOf(*now.motion.closedForm(), now.state.time, direction_),
                          subject.polhode.regime == view::Regime::separatrix);
    if (!figures_are_told_) canvas.put(labelOf(subject, kFlips, layout::kFlipsDepth, flips_, layout::kFlipsHeight));
  }

  void appendFigures(const Subject& subject, const session::Tick& tick, const Figures& figures,
                     Canvas& canvas) override {
    if (!figures_cadence_.due(tick.stamp)) return;
    figures_are_told_ = true;
    const std::string words = method_ + comparisonInWords(figures) +
                              (std::isnan(figures.cost) ? "" : formatted("\ncost %.3g us per s", 1e6 * figures.cost)) +
                              (flips_.empty() ? "" : "\n" + flips_);
    canvas.remove(subject.factory.ns(kFlips), kFlips, kFlips + 1);
    const auto lines = 1 + std::count(words.begin(), words.end(), '\n');
    const double depth = layout::kFiguresDepth + layout::kFiguresDepthALine * static_cast<double>(lines);
    Marker label = labelOf(subject, kFigures, depth, words, layout::kFiguresHeight);
    label.header.stamp = toTime(tick.stamp);
    canvas.put(label);
  }

  void clearTrail() override { flips_cadence_.reset(); }

  void sendAllNext() override {
    figures_cadence_.reset();
    flips_cadence_.reset();
  }

 private:
  std::string method_;  ///< with its step
  bool may_flip_;
  std::string flips_;              ///< in words, when they were told last
  double direction_ = 1;           ///< of play, when it was not paused
  bool figures_are_told_ = false;  ///< and the flips with them
  Cadence figures_cadence_{kFiguresPause}, flips_cadence_{kFlipsPause};
};

void appendPictureTitle(const Subject& subject, LabelId id, const Eigen::Vector3d& centre, const std::string& words,
                        Canvas& canvas) {
  const view::BodyPlace& place = subject.frame.place;
  if (place.titles == view::PictureTitles::none) return;
  const std::string whose = place.titles == view::PictureTitles::named ? subject.name + " " : "";
  canvas.put(subject.factory.text(id, names::kWorld, subject.belowTitle(centre, place.picture_title_depth, 0),
                                  whose + words, layout::kTitleHeight));
}

}  // namespace

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void appendBodyTitle(const Subject& subject, Canvas& canvas) {
  canvas.put(labelOf(subject, kBodyTitle, 0, subject.name, layout::kTitleHeight));
}

void appendPictureTitles(const Subject& subject, Canvas& canvas) {
  const view::BodyPlace& place = subject.frame.place;
  appendPictureTitle(subject, kSpaceTitle, place.space_centre, "in world axes", canvas);
  appendPictureTitle(subject, kModelTitle, place.model_centre, "in body axes", canvas);
}

void appendEllipsoidNames(const Subject& subject, Canvas& canvas) {
  const view::BodyPlace& place = subject.frame.place;
  if (!place.shows_world) return;  // there, the words below the picture in body axes have the room
  const auto put = [&](LabelId id, const char* words, double to_the_right, const std_msgs::ColorRGBA& colour) {
    Eigen::Vector3d at = subject.belowTitle(place.space_centre, place.picture_title_depth, layout::kNamesDepth);
    at.y() += to_the_right * subject.frame.text * subject.unit();
    canvas.put(subject.factory.text(id, names::kWorld, at, words, layout::kNamesHeight, colour));
  };
  put(kEnergyName, "energy", -layout::kNamesApart, palette::kEnergy);
  put(kMomentumName, "momentum", layout::kNamesApart, palette::kMomentumName);
}

std::unique_ptr<Part> makeWords(const Subject& subject, const MotionSetup& setup) {
  return std::make_unique<Words>(subject, setup);
}

}  // namespace poinsot::node::parts

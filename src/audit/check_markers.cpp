#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "checks.h"

namespace poinsot::audit {
namespace {

constexpr double kDrawn = 1e-9;  // relative: rounding of doubles that are squared and added
constexpr double kPolhode = 1e-6;
constexpr double kTooSmall = 0.01;  // m: ellipsoids of a body that is nearly at rest may be left out
constexpr double kMostLift = 1.05;  // by which a polhode may be enlarged so that it does not sink into the surface

std::string triple(const Eigen::Vector3d& v) {
  return text("(%.6g, %.6g, %.6g)", v.x(), v.y(), v.z());
}

std::vector<const Drawing*> drawingsOf(const Body& body, const std::string& what) {
  std::vector<const Drawing*> found;
  for (const Drawing& d : body.drawings) {
    if (d.flaw.empty() && d.name_space == body.name + "/" + what) found.push_back(&d);
  }
  return found;
}

/** An ellipsoid as drawn, in the body axes of its picture. */
struct Ellipsoid {
  Eigen::Isometry3d axes;  ///< of the ellipsoid → of the picture
  Eigen::Vector3d semi;    ///< [m]
  bool is_sphere;          ///< whether it is a SPHERE marker

  /** Returns Σ(xᵢ/aᵢ)²: 1 on the surface. */
  double valueAt(const Eigen::Vector3d& point) const {
    return (axes.inverse(Eigen::Isometry) * point).cwiseQuotient(semi).squaredNorm();
  }
};

/** A quantity that an ellipsoid shows. */
enum Shows { kEnergy, kMomentum };
constexpr const char* kNames[] = {"energy", "momentum"};

/** A state that can be used, and its segment. */
struct Known {
  const State* state;
  const Segment* segment;

  const Inertia& inertia() const { return segment->body->inertia(); }
  /** Returns the scale of the picture [m/(rad/s)]. */
  double scale() const { return segment->description->metres_per_radian_per_second; }
  /** Returns scale()·|L|, which divided by a moment is a semi-axis of the momentum ellipsoid. */
  double drawnMomentum() const { return scale() * (inertia().tensor * state->omega_body).norm(); }

  /** Returns √(2E/μ) or |L|/μ along the ellipsoid's own axes, as drawn [m]. */
  Eigen::Vector3d semiAxes(Shows shows, const Eigen::Matrix3d& axes) const {
    const Eigen::Vector3d mu = (axes.transpose() * inertia().tensor * axes).diagonal();
    if (shows == kMomentum) return drawnMomentum() * mu.cwiseInverse();
    return scale() * (2 * inertia().energy(state->omega_body) / mu.array()).sqrt();
  }
  /** Returns how far axes are from principal ones: the largest product of inertia, relative to the largest moment. */
  double skew(const Eigen::Matrix3d& axes) const {
    Eigen::Matrix3d m = axes.transpose() * inertia().tensor * axes;
    m.diagonal().setZero();
    return m.cwiseAbs().maxCoeff() / inertia().moments[2];
  }
  double condition() const { return inertia().moments[2] / inertia().moments[0]; }
};

/** Returns the ellipsoid with the smallest figure; the end where there is none. */
template <class Figure>
std::vector<Ellipsoid>::const_iterator nearest(const std::vector<Ellipsoid>& all, const Figure& figure) {
  return std::min_element(all.begin(), all.end(),
                          [&figure](const Ellipsoid& a, const Ellipsoid& b) { return figure(a) < figure(b); });
}

std::string wrongSize(Shows shows, const Ellipsoid& drawn, const Known& known) {
  const Eigen::Matrix3d axes = drawn.axes.linear();
  const Eigen::Vector3d wanted = known.semiAxes(shows, axes);
  const auto are = [&drawn](const Eigen::Vector3d& other) {
    return (drawn.semi.cwiseQuotient(other).array() - 1).abs().maxCoeff() < 1e-3;
  };
  const bool energy = shows == kEnergy;
  std::string out = std::string(kNames[shows]) + " ellipsoid's semi-axes are " + triple(drawn.semi) + " m, expected " +
                    (energy ? "sqrt(2E/mu) = " : "|L|/mu = ") + triple(wanted) + " m";
  if (known.skew(axes) > 1e-6) return out + "; its axes are not the principal axes";
  if (are(0.5 * wanted))
    return out + ": they are half of that, so scale was given as a radius where a SPHERE marker takes a diameter";
  if (are(2 * wanted)) return out + ": they are twice that";
  if (energy && are(std::sqrt(0.5) * wanted)) return out + ": they are sqrt(E/mu)";
  const Eigen::Vector3d mu = (axes.transpose() * known.inertia().tensor * axes).diagonal();
  if (!energy && are(known.drawnMomentum() * mu.cwiseSqrt().cwiseInverse())) out += ": they are sqrt(F/mu)";
  return out;
}

/** One of the two pictures, and the checks of it. */
class Picture {
 public:
  Picture(const Evidence& evidence, const char* name)
      : evidence_(evidence),
        body_(evidence.body),
        name_(name),
        free_(body_.isFree()),
        omega_(drawingsOf(body_, name_ + "/omega")),
        polhode_(drawingsOf(body_, name_ + "/polhode")) {
    for (const Shows shows : {kEnergy, kMomentum}) {
      for (const Drawing* d : drawingsOf(body_, name_ + "/" + kNames[shows] + "_ellipsoid")) {
        if (frame_.empty()) frame_ = d->frame_id;
        if (d->stamp == 0) {
          fixed_[shows].push_back(d);
        } else {
          moving_[shows].emplace(d->stamp, d);
        }
      }
    }
    if (!omega_.empty()) frame_ = omega_.front()->frame_id + (name_ == "model" ? "" : "_body");
    for (const Segment& segment : evidence_.segments) {
      for (const State* s : segment.states) states_.emplace(s->stamp, Known{s, &segment});
    }
  }

  bool empty() const { return frame_.empty(); }

  void judge(bool wants_polhode, std::vector<Check>& checks) {
    judgeSemiAxes(kEnergy, checks);
    judgeSemiAxes(kMomentum, checks);
    judgeOmega(checks);
    if (wants_polhode || !polhode_.empty()) judgePolhode(checks);
  }

 private:
  using Moving = std::multimap<Stamp, const Drawing*>;

  /**
   * Returns the ellipsoids that are shown at a stamp, as far as they can be placed in a frame: those sent with that
   * stamp, else, for a free body, those that do not change.
   */
  std::vector<Ellipsoid> at(Stamp stamp, Shows shows, const std::string& frame) const {
    const auto [begin, end] = moving_[shows].equal_range(stamp);
    std::vector<const Drawing*> drawings;
    for (auto it = begin; it != end; ++it) drawings.push_back(it->second);
    if (drawings.empty() && free_) drawings = fixed_[shows];
    std::vector<Ellipsoid> found;
    for (const Drawing* d : drawings) {
      const auto to = evidence_.transforms.between(d->frame_id, frame, stamp);
      const bool is_sphere = d->type == visualization_msgs::Marker::SPHERE;
      if (to) found.push_back({*to * Eigen::Translation3d(d->position) * d->orientation, 0.5 * d->scale, is_sphere});
    }
    return found;
  }

  std::string label(const std::string& what) const { return what + " (" + name_ + ")"; }

  /** Returns the relative drift of E or |L|² that the method is allowed, by which the motion may leave
   * the ellipsoids. */
  double allowed(Shows shows, const Known& known) const {
    if (!free_) return 0;  // drawn anew from each state
    const Bounds& bounds = known.segment->bounds;
    const double drift = shows == kEnergy ? bounds.energy(*known.state) : 2 * bounds.momentum(*known.state);
    // Where the method is unknown or too coarse, judgeConstants() holds the drift to this ceiling.
    return std::isfinite(drift) ? drift : 2 * evidence_.options.drift;
  }

  /** Compares the ellipsoids with each state; where several were sent, the one that fits best. */
  void judgeSemiAxes(Shows shows, std::vector<Check>& checks) {
    const std::string what = kNames[shows];
    Judge judge(label(what + " ellipsoid"), body_.key);
    judge.ifNothing("no " + what + "_ellipsoid marker to compare with");
    const Moving& moving = moving_[shows];
    std::int64_t missing = 0;
    if (!free_ && !fixed_[shows].empty()) {
      judge.fail(0, "an ellipsoid does not change although the body's energy and momentum do");
    }
    for (const auto& [stamp, known] : states_) {
      const double rate = known.inertia().fastestRate(known.state->omega_body), at_stamp = seconds(stamp);
      if (rate == 0) continue;
      if (!moving.empty() && !moving.count(stamp) && known.scale() * rate > kTooSmall &&
          stamp > moving.begin()->first && stamp < moving.rbegin()->first) {
        ++missing;
      }
      const auto off = [&, known = known](const Ellipsoid& drawn) {
        const Eigen::Matrix3d axes = drawn.axes.linear();
        const Eigen::Vector3d ratio = drawn.semi.cwiseQuotient(known.semiAxes(shows, axes));
        return std::max((ratio.array() - 1).abs().maxCoeff(), known.skew(axes));
      };
      const std::vector<Ellipsoid> drawn_ones = at(stamp, shows, frame_);
      const auto best = nearest(drawn_ones, off);
      if (best == drawn_ones.end()) continue;
      judge.compare(off(*best), kDrawn + 1e-15 * known.condition() + allowed(shows, known), at_stamp,
                    [&, known = known] { return wrongSize(shows, *best, known); });
      if (!best->is_sphere) judge.fail(at_stamp, "the ellipsoid is not a SPHERE marker");
    }
    if (!free_ && static_cast<double>(missing) > evidence_.options.losses * static_cast<double>(body_.states.size())) {
      judge.fail(0, text("%lld states between others have no ellipsoid", static_cast<long long>(missing)));
    }
    checks.push_back(judge.verdict());
  }

  /** Returns, of the states at a stamp, the one whose Ω is nearest to the drawn one; or nullptr. */
  const Known* stateAt(Stamp stamp, const Eigen::Vector3d& drawn, bool world) const {
    const auto [begin, end] = states_.equal_range(stamp);
    const auto off = [&](const Known& k) {
      return (k.scale() * (world ? k.state->omega_world : k.state->omega_body) - drawn).norm();
    };
    const auto best =
        std::min_element(begin, end, [&](const auto& a, const auto& b) { return off(a.second) < off(b.second); });
    return best == end ? nullptr : &best->second;
  }

  void judgeOmega(std::vector<Check>& checks) {
    const bool space = name_ == "space";
    Judge drawn(label("omega drawn to scale"), body_.key), on(label("omega on both ellipsoids"), body_.key);
    for (Judge* judge : {&drawn, &on}) judge->ifNothing("no " + name_ + "/omega marker at the stamp of a state");
    std::int64_t unplaced = 0;
    std::string unplaced_why;
    // Where a clock jumped back, a stamp may belong to several states, some of which were not recorded.
    std::map<Stamp, std::int64_t> stateless;
    for (const Drawing* d : omega_) stateless[d->stamp] += body_.jumps > 0;
    for (const auto& [stamp, known] : states_) --stateless[stamp];
    for (const Drawing* d : omega_) {
      const double at_stamp = seconds(d->stamp);
      const Eigen::Isometry3d pose = Eigen::Translation3d(d->position) * d->orientation;
      Eigen::Vector3d centre = Eigen::Vector3d::Zero(), tip = d->position;
      if (space) {
        if (d->type != visualization_msgs::Marker::ARROW || d->points.size() != 2) {
          drawn.fail(at_stamp, "space/omega is not an ARROW from one point to another");
          continue;
        }
        centre = pose * d->points[0];
        tip = pose * d->points[1];
      } else if (d->type != visualization_msgs::Marker::SPHERE) {
        drawn.fail(at_stamp, "model/omega is not a SPHERE");
        continue;
      }
      const Known* known = stateAt(d->stamp, tip - centre, space);
      if (!known || known->state->omega_body.norm() == 0) continue;  // judgeMarkerForm reports what has no state
      const State* s = known->state;
      const Eigen::Vector3d wanted = known->scale() * (space ? s->omega_world : s->omega_body);
      const double off = ((tip - wanted).norm() + centre.norm()) / wanted.norm();
      if (off > kDrawn && stateless[d->stamp] > 0) {
        --stateless[d->stamp];
        continue;
      }
      drawn.compare(off, kDrawn, at_stamp, [&] {
        return name_ + "/omega is drawn at " + triple(tip) + " m" +
               (centre.norm() > 0 ? " from " + triple(centre) : "") + ", metres_per_radian_per_second times " +
               (space ? "omega_world" : "omega_body") + " is " + triple(wanted);
      });

      // Where the point lies in the axes in which the ellipsoids stand still.
      std::optional<Eigen::Isometry3d> to_body =
          evidence_.transforms.between(d->frame_id, frame_, d->stamp, s->attitude);
      if (!to_body && space && !evidence_.options.tf) to_body = Eigen::Isometry3d(s->attitude.conjugate());
      if (!to_body) {
        if (unplaced++ == 0) unplaced_why = "no tf from " + d->frame_id + " to " + frame_ + " at the stamp of a marker";
        continue;
      }
      const Eigen::Vector3d point = *to_body * tip;
      for (const Shows shows : {kEnergy, kMomentum}) {
        const auto value = [&point](const Ellipsoid& e) { return e.valueAt(point) - 1; };
        const std::vector<Ellipsoid> drawn_ones = at(d->stamp, shows, frame_);
        const auto nearest_one = nearest(drawn_ones, [&value](const Ellipsoid& e) { return std::abs(value(e)); });
        if (nearest_one == drawn_ones.end()) {
          if (unplaced++ == 0) unplaced_why = "no ellipsoid to compare with";
          continue;
        }
        const double best = value(*nearest_one);
        on.compare(std::abs(best), kDrawn + 1e-15 * std::pow(known->condition(), 2) + allowed(shows, *known), at_stamp,
                   [&] {
                     return text("omega lies %s the %s ellipsoid as drawn: sum((x/a)^2) = %.9g",
                                 best > 0 ? "outside" : "inside", kNames[shows], 1 + best);
                   });
      }
    }
    const double share = evidence_.options.losses * static_cast<double>(on.count() + unplaced);
    // Markers before the first or after the last tf may lack it; "tf = state" judges where the recording of tf ends.
    if (on.count() == 0 && unplaced > 0) {
      on.ifNothing(unplaced_why);
    } else if (static_cast<double>(unplaced) > share && unplacedInside()) {
      on.fail(0, unplaced_why + text(" (%lld of %zu markers)", static_cast<long long>(unplaced), omega_.size()));
    }
    checks.push_back(drawn.verdict());
    checks.push_back(on.verdict());
  }

  /** Returns whether a marker lacks its tf although tf was received before and after it. */
  bool unplacedInside() const {
    if (name_ != "space" || omega_.empty()) return true;
    const Track<Transform>* turning = evidence_.transforms.moving(frame_);
    if (!turning) return true;
    return std::any_of(omega_.begin(), omega_.end(), [&known = turning->by_stamp](const Drawing* d) {
      return d->stamp >= known.begin()->first && d->stamp <= known.rbegin()->first && !known.count(d->stamp);
    });
  }

  void judgePolhode(std::vector<Check>& checks) {
    Judge judge(label("polhode on both ellipsoids"), body_.key);
    judge.ifNothing("no " + name_ + "/polhode marker");
    for (const Drawing* d : polhode_) {
      const bool line =
          d->type == visualization_msgs::Marker::LINE_STRIP || d->type == visualization_msgs::Marker::LINE_LIST;
      const bool points =
          d->type == visualization_msgs::Marker::SPHERE_LIST || d->type == visualization_msgs::Marker::POINTS;
      if (!(line && d->points.size() >= 2) && !(points && !d->points.empty())) {
        judge.fail(seconds(d->stamp), "polhode: expected a line of at least two points, or a list of points");
        continue;
      }
      // Several pairs of ellipsoids may have been drawn in turn: the polhode belongs to the pair on which it lies best.
      double best = std::numeric_limits<double>::infinity(), best_lift = 0;
      const Eigen::Isometry3d pose = Eigen::Translation3d(d->position) * d->orientation;
      for (const Ellipsoid& energy : at(d->stamp, kEnergy, d->frame_id)) {
        for (const Ellipsoid& momentum : at(d->stamp, kMomentum, d->frame_id)) {
          Eigen::ArrayXd values(2 * d->points.size());
          for (std::size_t i = 0; i < d->points.size(); ++i) {
            const Eigen::Vector3d p = pose * d->points[i];
            values.segment<2>(2 * static_cast<Eigen::Index>(i)) << energy.valueAt(p), momentum.valueAt(p);
          }
          const double mean = values.mean(), worst = (values / mean - 1).abs().maxCoeff();
          if (worst < best) {
            best = worst;
            best_lift = std::sqrt(mean);
          }
        }
      }
      if (!std::isfinite(best)) continue;
      judge.compare(best, kPolhode, seconds(d->stamp), [&] {
        return text("a point of the polhode is off the ellipsoids by %.3g (with the common lift of %.4f undone)", best,
                    best_lift);
      });
      judge.compare(std::max(best_lift - kMostLift, 1 - best_lift), kPolhode, seconds(d->stamp), [&] {
        return text("the polhode is drawn at %.4f times its size; expected 1 to %g", best_lift, kMostLift);
      });
    }
    checks.push_back(judge.verdict());
  }

  const Evidence& evidence_;
  const Body& body_;
  std::string name_;
  std::string frame_;  ///< with the body axes of the picture: of the model its own, in space the one that turns
  bool free_;
  std::vector<const Drawing*> omega_, polhode_, fixed_[2];  ///< ellipsoids: by what they show
  Moving moving_[2];
  std::multimap<Stamp, Known> states_;
};

/** @param moves whether something drawn of this body must move. */
void judgeMarkerForm(const Body& body, bool moves, std::vector<Check>& checks) {
  Judge form("markers well formed", body.key), stamps("marker stamps are states' stamps", body.key, "s");
  form.ifNothing("no marker of this body was received");
  stamps.ifNothing("no moving marker of this body was received");
  std::map<Stamp, const State*> of_states;
  for (const State& s : body.states) of_states.emplace(s.stamp, &s);
  for (const Drawing& d : body.drawings) {
    const double at = seconds(d.stamp);
    form.compare(d.flaw.empty() ? 0 : 1, 0, at, [&] { return d.name_space + ": " + d.flaw; });
    const double norm = d.flaw.empty() ? d.orientation_as_sent.norm() : 1;
    form.compare(std::abs(1 - norm), 1e-12, at, [&] {
      return text("%s: expected a unit quaternion, got the norm %.12g", d.name_space.c_str(), norm);
    });
    if (d.stamp == 0 || d.stamp < of_states.begin()->first || d.stamp > of_states.rbegin()->first) continue;
    const double off = std::abs(toNearest(of_states, d.stamp));
    stamps.compare(off, 0, at,
                   [&] { return text("a marker's stamp is that of no state; the nearest is %.1f ms off", 1e3 * off); });
  }
  checks.push_back(form.verdict());
  if (moves || stamps.count() > 0) checks.push_back(stamps.verdict());
}

/** Returns whether Ω moves in the body, so that its polhode is more than a point. */
bool omegaMoves(const std::vector<Segment>& segments) {
  const Eigen::Vector3d& omega = segments.front().first().omega_body;
  return std::any_of(segments.begin(), segments.end(), [&omega](const Segment& segment) {
    return std::any_of(segment.states.begin(), segment.states.end(),
                       [&omega](const State* s) { return (s->omega_body - omega).norm() > 1e-3 * omega.norm(); });
  });
}

}  // namespace

void judgeNoPictures(const Body& body, std::vector<Check>& checks) {
  Judge judge("no pictures", body.key);
  judge.ifNothing("no marker of this body");
  for (const Drawing& d : body.drawings) {
    const bool is_picture =
        d.name_space.find("/space/") != std::string::npos || d.name_space.find("/model/") != std::string::npos;
    judge.compare(is_picture ? 1 : 0, 0, seconds(d.stamp),
                  [&] { return d.name_space + " is drawn of a body that has no pictures by the layout"; });
  }
  checks.push_back(judge.verdict());
}

void judgeMarkers(const Evidence& evidence, std::vector<Check>& checks) {
  const Body& body = evidence.body;
  const bool free = body.isFree();
  const bool turns = std::any_of(body.states.begin(), body.states.end(),
                                 [](const State& s) { return s.flaw.empty() && s.omega_body.norm() > 0; });
  judgeMarkerForm(body, free && turns, checks);
  if (!turns) return;  // at rest: ellipsoids of no size
  for (const char* name : {"model", "space"}) {
    Picture picture(evidence, name);
    // A free body must have both pictures; of others, those that are drawn are judged.
    if (free || !picture.empty()) picture.judge(free && omegaMoves(evidence.segments), checks);
  }
}

}  // namespace poinsot::audit

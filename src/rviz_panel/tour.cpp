#include "tour.h"

#include <QSet>
#include <algorithm>
#include <cmath>

#include "data_file.h"
#include "status.h"

namespace poinsot::rviz_panel {
namespace {

using data_file::Error;
using data_file::textOf;

constexpr int kMostCards = 50;
constexpr int kLongestTitle = 30;  // letters
constexpr int kLongestName = 80;
constexpr int kLongestText = 200;
constexpr double kFastest = 100;  // as on the slider
const char* const kTourSource = "panel/tour.yaml";

void requireKnownKeys(const rviz::Config& map, const QSet<QString>& known, const QString& place) {
  QStringList sorted = known.values();
  std::sort(sorted.begin(), sorted.end());
  for (rviz::Config::MapIterator i = map.mapIterator(); i.isValid(); i.advance()) {
    if (!known.contains(i.currentKey())) throw Error(place, "one of " + sorted.join(", "), i.currentKey());
  }
}

/** Returns a number; `otherwise` where there is none. Throws Error where it is not finite or larger than `most`. */
double numberOf(const rviz::Config& map, const QString& key, const QString& place, double otherwise, double most) {
  QString text;
  if (!map.mapGetString(key, &text)) return otherwise;
  bool ok = false;
  const double out = text.toDouble(&ok);
  if (!ok || !(std::abs(out) <= most))
    throw Error(place, QString("a number up to %1 under %2").arg(most).arg(key), text);
  return out;
}

bool flagOf(const rviz::Config& map, const QString& key, const QString& place) {
  QString text;
  if (!map.mapGetString(key, &text)) return false;
  if (text != "true" && text != "false") throw Error(place, "true or false under " + key, text);
  return text == "true";
}

void readMethod(const rviz::Config& map, const QString& place, Card* card) {
  requireKnownKeys(map, {"body", "name", "step"}, place);
  card->body = textOf(map, "body", place, kLongestName);
  card->method = textOf(map, "name", place, kLongestName);
  card->step = numberOf(map, "step", place, 0, 1e6);
  if (card->step < 0) throw Error(place, "a step that is not negative", QString::number(card->step));
}

Card cardOf(const rviz::Config& map, const QString& place) {
  requireKnownKeys(map, {"title", "says", "scene", "view", "time", "speed", "paused", "method"}, place);
  Card out;
  out.title = textOf(map, "title", place, kLongestTitle);
  out.says = textOf(map, "says", place, kLongestText);
  out.scene = textOf(map, "scene", place, kLongestName);
  out.view = textOf(map, "view", place, kLongestName);
  out.time = numberOf(map, "time", place, std::nan(""), 1e9);
  if (std::isnan(out.time)) throw Error(place, "a number under time", "none");
  out.speed = numberOf(map, "speed", place, 1, kFastest);
  if (out.speed == 0) throw Error(place, "a speed that is not 0", "0");
  out.paused = flagOf(map, "paused", place);
  const rviz::Config method = map.mapGetChild("method");
  if (method.isValid()) readMethod(method, place + ", method", &out);
  return out;
}

}  // namespace

QVector<Card> tourCards(const QString& text) {
  const rviz::Config list = data_file::listFrom(text, kTourSource, kMostCards);
  QVector<Card> out;
  for (int i = 0; i < list.listLength(); ++i) {
    out.push_back(cardOf(list.listChildAt(i), QString("%1: card %2").arg(kTourSource).arg(i + 1)));
  }
  return out;
}

bool Tour::canGo(int by) const {
  const int to = placeAfter(by);
  return to >= 0 && to < size();
}

Tour::Act Tour::go(int by) {
  if (!canGo(by)) return Act::nothing;
  wanted_ = placeAfter(by);
  stage_ = Stage::loading;
  segment_ = newest_.segment;
  refused_ = newest_.refused;
  return Act::load_scene;
}

Tour::Act Tour::onStatus(const NodeStatus& status) {
  newest_ = status;
  if (isSought(status)) segment_ = status.segment;
  if (!underWay()) return Act::nothing;
  if (!status.refused.empty() && status.refused != refused_) {
    fail();
    return Act::nothing;
  }
  // A status from before the node was asked has the segment of that time.
  if (isChanging(status) || status.segment == segment_ || status.scene != card().scene.toStdString()) {
    return Act::nothing;
  }
  if (stage_ == Stage::loading && !card().method.isEmpty()) {
    stage_ = Stage::changing_method;
    segment_ = status.segment;
    return Act::set_method;
  }
  if (stage_ == Stage::changing_method) {
    const BodyStatus* const body = bodyNamed(status, card().body);
    if (!body || body->method != card().method.toStdString()) return Act::nothing;
  }
  stage_ = Stage::there;
  shown_ = wanted_;
  if (card().time != 0) sought_ = card().time;
  sought_in_ = status.segment;
  return Act::arrive;
}

bool Tour::isSought(const NodeStatus& status) {
  if (!sought_ || status.segment == sought_in_) return false;
  // A scene begins at 0.
  const bool out = std::abs(status.time - *sought_) < std::abs(status.time);
  sought_.reset();
  return out;
}

void Tour::fail() {
  stage_ = Stage::there;
  sought_.reset();
}

}  // namespace poinsot::rviz_panel

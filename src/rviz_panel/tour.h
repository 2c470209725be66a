#pragma once

#include <poinsot/NodeStatus.h>

#include <QString>
#include <QVector>
#include <cstdint>
#include <optional>
#include <string>

namespace poinsot::rviz_panel {

/** One stop of the tour: what is played, from where it is seen, and what is said about it. */
struct Card {
  QString title;
  QString says;
  QString scene;     ///< its name
  QString view;      ///< a saved view of rviz/demo.rviz
  double time = 0;   ///< where it begins [s]
  double speed = 1;  ///< of play; negative backwards
  bool paused = false;
  QString body;     ///< that another method moves; empty: none
  QString method;   ///< that moves it
  double step = 0;  ///< of the method [s]; 0: chosen by the node
};

/**
 * Returns the cards that a text like that of panel/tour.yaml says. Throws data_file::Error for anything else: a key
 * that is not known or is missing, a text that is too long, a number that is not finite or out of range.
 */
QVector<Card> tourCards(const QString& text);

/**
 * A tour from card to card. It stays on its card until the next one's scene and method are there, and where they are
 * refused.
 */
class Tour {
 public:
  /** What is to be asked of the node. */
  enum class Act {
    nothing,
    load_scene,
    set_method,
    arrive  ///< time, speed, pause and view are those of the card, which is shown from now on
  };

  explicit Tour(const QVector<Card>& cards) : cards_(cards) {}

  int size() const { return cards_.size(); }
  /** The card that is shown, from 0; -1 before the first has been reached. */
  int shown() const { return shown_; }
  const Card& shownCard() const { return cards_[shown_]; }
  bool underWay() const { return stage_ != Stage::there; }
  /** The card that the tour is on its way to, or has reached. There is one after go(). */
  const Card& card() const { return cards_[wanted_]; }

  bool canGo(int by) const;
  /** Sets off for the card so many further on; nothing where there is none. */
  Act go(int by);
  /** What the node says leads on. */
  Act onStatus(const NodeStatus& status);
  /** What was asked for is refused, or the node is gone: the tour stays where it is. */
  void fail();

 private:
  /** Whether the segment began at the time that the last card asked for, and not with the scene of the next one. */
  bool isSought(const NodeStatus& status);
  int placeAfter(int by) const { return (underWay() ? wanted_ : shown_) + by; }

  enum class Stage { there, loading, changing_method };

  QVector<Card> cards_;
  int shown_ = -1;
  int wanted_ = -1;
  Stage stage_ = Stage::there;
  NodeStatus newest_;
  std::uint32_t segment_ = 0;     ///< when the node was asked
  std::string refused_;           ///< likewise
  std::optional<double> sought_;  ///< the time that the card asked for, until the node is there [s]
  std::uint32_t sought_in_ = 0;   ///< the segment when it was asked for
};

}  // namespace poinsot::rviz_panel

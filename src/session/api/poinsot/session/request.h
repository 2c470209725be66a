#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/** What may be asked of a session, and its answers. */
namespace poinsot::session {

/** Plays another scene from its start. */
struct LoadScene {
  std::string scene;  ///< a name or a path; empty: the present scene's file, read again
};
/** Moves a body by another method, from the same start. */
struct SetMethod {
  std::string body, method;
  std::optional<double> step;  ///< [s]; nothing: one that suits the body's motion
};
/** Starts a body anew from where it is; t = 0 for the whole scene. */
struct SetSpin {
  std::string body;
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  ///< [rad/s], the scene's axes
};
/** Back to t = 0, and to the scene's own spins. */
struct Reset {};
/** To another time. */
struct Seek {
  double time = 0;  ///< [s]
};
struct Pause {
  bool paused = true;
};
/** While paused: on by one period of the ticks. */
struct Step {};
struct SetSpeed {
  double speed = 1;  ///< of play; negative backwards
};

using Request = std::variant<LoadScene, SetMethod, SetSpin, Reset, Seek, Pause, Step, SetSpeed>;

/** Returns whether two requests ask for the same thing of the same body, so that the later one replaces the other. */
bool sameKind(const Request& a, const Request& b);

/** Why something was not done. */
enum class Reason {
  not_finite,      ///< a speed or a time
  too_fast,        ///< the steps would take more of this machine than there is
  too_many_steps,  ///< to the time that was asked for
  no_state,        ///< the motion has left the range of doubles there
  not_paused,      ///< a step is possible only while paused
  cannot_be_made,  ///< working it out failed; `detail` says why
  bad_request      ///< `detail` says all of it
};

struct Refusal {
  Reason reason = Reason::bad_request;
  std::vector<Request> requests;  ///< all that are refused together
  std::string detail;             ///< what the part that found the fault said of it
  std::string body, method;       ///< too_many_steps, no_state
  double figure = 0, limit = 0;   ///< found, and the most that is accepted. too_fast: CPU s per simulated s (SetSpeed:
                                  ///< `limit` is the largest speed); too_many_steps: their number
  double step = 0;                ///< too_many_steps [s]
  double speed = 0;               ///< too_fast: of play
};

Refusal refusalOf(Reason reason, const std::vector<Request>& requests, const std::string& detail = {});

/** What becomes of a request. */
struct Answer {
  std::optional<Refusal> refusal;
  std::string scene;                  ///< LoadScene: the name of the scene that is being made ready
  std::string method;                 ///< SetMethod: what was chosen,
  std::optional<double> step;         ///< and with what step [s]
  std::vector<std::string> warnings;  ///< of that choice
  bool in_the_background = false;     ///< Reset: it is being worked out
  bool spins = false;                 ///< Reset: spins are brought back too
};

/** Returns the answer to a bad request, with `problem` as its detail. */
Answer refusedFor(const std::string& problem);

}  // namespace poinsot::session

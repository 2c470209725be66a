#pragma once

#include "phases.h"

// Compiled once for each instruction set: see levels.h. Nothing here may be shared between them.
//
// States on a uniform grid, block by block: the phases are computed in full at the beginning of each block, and from
// there on, where possible, by one multiplication a state.
namespace poinsot::closed_form::POINSOT_SIMD_LEVEL {

constexpr int kBlock = 64;
constexpr int kLanes = 8;  // blocks are rounded up to whole vectors; states beyond the end are dropped

/** The factors by which a phase advances in k steps, k = 0 … kBlock − 1. */
struct Table {
  alignas(64) double index[kBlock];  ///< k, because converting integers would halve the width of the vector code
  alignas(64) double cos[kBlock], sin[kBlock];  ///< of 2πk·step

  Table(SplitPhase step, int n) {
    for (int k = 0; k < n; ++k) index[k] = k;
    for (int k = 0; k < n; ++k) {
      const SinCos turn = turnBy({index[k] * step.grid, index[k] * step.rest}, 0.0);
      cos[k] = turn.cos;
      sin[k] = turn.sin;
    }
  }
  SinCos turn(int k) const { return {sin[k], cos[k]}; }
};

/** e^{±k·step}, k = 0 … kBlock − 1 */
struct ExponentialTable {
  alignas(64) double decay[kBlock], growth[kBlock];

  ExponentialTable(double step, int n) {
    for (int k = 0; k < n; ++k) {
      const Exponentials e = exponentials(step * k, 0.0);
      decay[k] = e.decay;
      growth[k] = e.growth;
    }
  }
};

struct Block {
  alignas(64) double attitude[4][kBlock], omega[3][kBlock];

  POINSOT_INLINE void keep(int k, const Evaluation& e) {
    for (int i = 0; i < 4; ++i) attitude[i][k] = e.attitude[i];
    for (int i = 0; i < 3; ++i) omega[i][k] = e.omega[i];
  }
};

class Grid {
 public:
  Grid(const Constants& c, double begin, double step, long n, double* const* columns)
      : c_(c), begin_(begin), step_(step), n_(n), columns_(columns) {}

  void run() {
    const DoubleDouble half_step = c_.rate.half * DoubleDouble(step_);
    const DoubleDouble turn_step = c_.rate.turn * DoubleDouble(step_);
    if (c_.series == Constants::Series::trigonometric) {
      const SplitPhase half = splitPhase(wrapped(half_step, 2)), turn = splitPhase(wrapped(turn_step, 1));
      if (c_.delicate) {
        runExactly<false, true>(half, turn);
      } else {
        runTrigonometric(half, turn);
      }
      return;
    }
    // A quarter period should be several blocks. The error at the beginning of a block is roundoff times |x|, which the
    // block should not carry from large |x| to x = 0.
    const double advance = magnitude(half_step.high) * kBlock;
    if (advance < 0.125 && advance * c_.span < 2) {
      if (c_.nome[1] < kShortNome) {
        runSmoothly<true>(half_step, turn_step);
      } else {
        runSmoothly<false>(half_step, turn_step);
      }
    } else if (c_.wraps != 0) {
      const SplitPhase half = splitPhase(wrapped(half_step, 2)), turn = splitPhase(wrapped(turn_step, 1));
      if (c_.nome[1] < kShortNome) {
        runExactly<true, true>(half, turn);
      } else {
        runExactly<true, false>(half, turn);
      }
    } else {
      // This phase does not wrap, so multiples of a long step would not be exact.
      for (long j = 0; j < n_; ++j) runSingly(j);
    }
  }

 private:
  DoubleDouble timeOf(long j) const { return exactProduct(static_cast<double>(j), step_) + begin_; }

  int roundedUp(int n) const { return (n + kLanes - 1) / kLanes * kLanes; }

  int size() const { return n_ < kBlock ? roundedUp(static_cast<int>(n_)) : kBlock; }

  void runSingly(long j) {
    Block block;
    const Phases phases = phasesAt(c_, timeOf(j));
    block.keep(0, evaluate(c_, splitPhase(phases.half), splitPhase(phases.turn)));
    write(block, j, 1);
  }

  void runTrigonometric(SplitPhase half_step, SplitPhase turn_step) {
    const Table turns(turn_step, size()), amplitudes({0.5 * half_step.grid, 0.5 * half_step.rest}, size());
    Block block;
    for (long first = 0; first < n_; first += kBlock) {
      const Phases base = phasesAt(c_, timeOf(first));
      const SinCos turn = turnBy(splitPhase(base.turn), 0.0), alpha = amplitude(splitPhase(base.half));
      const int count = n_ - first < kBlock ? static_cast<int>(n_ - first) : kBlock, padded = roundedUp(count);
      for (int k = 0; k < padded; ++k) {
        block.keep(k, trigonometric(c_, alpha * amplitudes.turn(k), turn * turns.turn(k)));
      }
      write(block, first, count);
    }
  }

  /** Blocks that cross neither x = 0 nor a whole half-period, so that E and H change by the same factor each time. */
  template <bool kShort>
  void runSmoothly(const DoubleDouble& half_step, const DoubleDouble& turn_step) {
    const DoubleDouble z_turn = c_.z_turn;
    const Table turns(splitPhase(wrapped(turn_step + half_step * z_turn, 1)), size());
    const ExponentialTable exponents(c_.span * magnitude(half_step.high), size());
    const SplitPhase step = splitPhase(asPair(half_step));
    const double speed = half_step.high;
    Block block;
    for (long first = 0; first < n_;) {
      const Phases base = phasesAt(c_, timeOf(first));
      const HyperbolicPlace place = hyperbolicPlace(c_, splitPhase(base.half));
      const bool inwards = place.d * speed < 0;  // |x| falls
      const double side = place.d != 0 ? place.side : speed < 0 ? -1.0 : 1.0;
      const double way = inwards ? magnitude(place.d) : c_.wraps != 0 ? 0.5 - magnitude(place.d) : kFarAlong;
      const double steps = way / magnitude(speed);
      const long room = n_ - first;
      int count = steps < kBlock - 1 ? static_cast<int>(steps) + 1 : kBlock;
      if (count > room) count = static_cast<int>(room);
      const int padded = roundedUp(count);
      const Decays start = decays(c_, place);
      const SinCos turn = turnBy(splitPhase(base.turn), c_.z_turn * place.d);
      const double* e_factor = inwards ? exponents.growth : exponents.decay;
      const double* h_factor = inwards ? exponents.decay : exponents.growth;
      const double nearest_end = inwards ? magnitude(place.d) : magnitude(place.d) + count * magnitude(speed);
      if (c_.delicate && c_.span * (0.5 - nearest_end) < 0.5) {
        for (int k = 0; k < padded; ++k) {
          const double grid = mulAdd(turns.index[k], step.grid, place.grid);
          const double rest = mulAdd(turns.index[k], step.rest, place.rest);
          const Decays exact = decays(c_, {grid, rest, grid + rest, side, place.parity});
          block.keep(k, hyperbolic<kShort>(c_, exact, side, place.parity, turn * turns.turn(k)));
        }
      } else {
        for (int k = 0; k < padded; ++k) {
          const double E = start.E * e_factor[k], H = start.H * h_factor[k];
          block.keep(k, hyperbolic<kShort>(c_, {E, 1.0 - E, H, 1.0 - H}, side, place.parity, turn * turns.turn(k)));
        }
      }
      write(block, first, count);
      first += count;
    }
  }

  /** Each phase of Ω computed by itself. */
  template <bool kHyperbolic, bool kShort>
  void runExactly(SplitPhase half_step, SplitPhase turn_step) {
    const Table turns(turn_step, size());
    Block block;
    for (long first = 0; first < n_; first += kBlock) {
      const Phases base = phasesAt(c_, timeOf(first));
      const SinCos start = turnBy(splitPhase(base.turn), 0.0);
      const SplitPhase half = splitPhase(base.half);
      const int count = n_ - first < kBlock ? static_cast<int>(n_ - first) : kBlock, padded = roundedUp(count);
      for (int k = 0; k < padded; ++k) {
        const SplitPhase v{mulAdd(turns.index[k], half_step.grid, half.grid),
                           mulAdd(turns.index[k], half_step.rest, half.rest)};
        const SinCos turn = start * turns.turn(k);
        if (kHyperbolic) {
          const HyperbolicPlace place = hyperbolicPlace(c_, v);
          block.keep(k, hyperbolic<kShort>(c_, decays(c_, place), place.side, place.parity,
                                           turn * sinCosSmall(2.0 * kPi * (c_.z_turn * place.d))));
        } else {
          block.keep(k, trigonometric(c_, amplitude(v), turn));
        }
      }
      write(block, first, count);
    }
  }

  void write(const Block& block, long first, int n) const {
    for (int i = 0; i < 4; ++i) __builtin_memcpy(columns_[i] + first, block.attitude[i], n * sizeof(double));
    for (int i = 0; i < 3; ++i) {
      const double amplitude = c_.omega[i], unit = c_.omega_unit, *source = block.omega[c_.from[i]];
      double* out = columns_[4 + i] + first;
      for (int k = 0; k < n; ++k) out[k] = unit * (amplitude * source[k]);
    }
  }

  const Constants& c_;
  double begin_, step_;  // scaled time
  long n_;
  double* const* columns_;
};

}  // namespace poinsot::closed_form::POINSOT_SIMD_LEVEL

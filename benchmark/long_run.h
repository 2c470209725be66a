#pragma once

/**
 * Runs every method for 1e8 steps, on a body that tumbles and on one whose steps are all rounded alike: prints a
 * Markdown section. False if a figure breaks its promise.
 */
bool printLongRuns();

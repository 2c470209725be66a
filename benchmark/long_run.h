#pragma once

/**
 * Every method for 1e8 steps, on a body that tumbles and on one whose steps all round alike: a Markdown section on
 * stdout. False where a figure breaks what is promised.
 */
bool printLongRuns();

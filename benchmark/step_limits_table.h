#pragma once

/**
 * How judgeStep() divides steps, over random bodies, against what then happens: a Markdown section on stdout. False
 * where a step that it lets pass is badly wrong, or one that it refuses is not.
 */
bool printStepLimits();

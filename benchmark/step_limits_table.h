#pragma once

/**
 * Compares the verdicts of judgeStep() on random bodies with what then happens: prints a Markdown section. False if a
 * step that passes is badly wrong, or one that is refused is not.
 */
bool printStepLimits();

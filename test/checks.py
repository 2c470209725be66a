"""What the tests that are Python programs share: import it after putting test/ into sys.path."""
passed = failed = 0


def check(name, complaints):
    """Prints PASS or FAIL with the name of a check, and the first of its complaints, of which a check that passes has none."""
    global passed, failed
    passed, failed = passed + (not complaints), failed + bool(complaints)
    print(("FAIL  " if complaints else "PASS  ") + name, flush=True)
    for complaint in complaints[:8]:
        print("        " + complaint)


def finish():
    """Prints the counts, as the last line. Returns the exit code."""
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0

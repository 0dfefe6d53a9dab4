# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests that need no window, all or those with one of the words in their name:

    blender --background --factory-startup --python run_tests.py -- ARCHIVE PROGRAM [WORD...]"""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True

import faulthandler; faulthandler.enable()
import support  # noqa: E402

support.install()
loader = unittest.TestLoader()
loader.testNamePatterns = [f"*{word}*" for word in support.WORDS] or None
suite = loader.discover(str(Path(__file__).parent), pattern="test_*.py")
is_good = unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() and suite.countTestCases() > 0
sys.exit(0 if is_good else 1)

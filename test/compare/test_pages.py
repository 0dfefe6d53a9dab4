"""Charts as the comparison of pages takes them: apart, whole, and on shelves."""

import sys
import unittest

import comparison  # noqa: F401, which finds the next module
import numpy as np
import pages


class Pages(unittest.TestCase):
    def test_apart(self):
        """Two squares on one place, and a triangle at a corner of one of them in the plane, but not in the mesh."""
        square = [(0, 0), (2, 0), (2, 1), (0, 1)]
        points = np.array(square + square + [(2, 1), (3, 1), (2, 4)], float)
        faces = np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7), (8, 9, 10)])
        moved, boxes = pages.apart(points, faces)
        self.assertEqual(boxes.tolist(), [[2, 1], [2, 1], [1, 3]])
        for chart in (range(4), range(4, 8), range(8, 11)):
            self.assertTrue(np.allclose(np.diff(moved[chart], axis=0), np.diff(points[chart], axis=0)))
        lows, highs = (np.array([end(moved[chart], axis=0) for chart in (range(4), range(4, 8), range(8, 11))])
                       for end in (np.min, np.max))
        for i in range(3):
            for j in range(i):
                self.assertTrue(np.any(lows[i] > highs[j]) or np.any(lows[j] > highs[i]), (i, j))

    def test_shelves(self):
        """Four boxes with margins fill a page of two shelves; a fifth one needs another page."""
        boxes = np.full((5, 2), 40.)
        self.assertEqual([pages.on_shelves(boxes[:n], 5, 95) for n in (1, 4, 5)], [1, 1, 2])
        self.assertEqual(pages.on_shelves(boxes[:4], 5, 94), 4)
        self.assertEqual(pages.on_shelves(np.array([[80., 20.], [20., 80.], [80., 20.]]), 5, 90), 1)  # all lying


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

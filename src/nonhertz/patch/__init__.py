"""Any gap on a plane grid: uniform-pressure rectangles, the independent check of the strips."""

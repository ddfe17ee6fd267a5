"""Loops of walls from the files of drawing programs: DXF, GDSII, SVG and PNG. The program carries this package and runs it.

A reader (dxf, gds, svg, png) puts what a file holds into a Drawing, in µm; `outlines` makes loops of it.
"""

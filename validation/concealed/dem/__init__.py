"""Specimens of bonded grains under YADE's own cohesive law; the effects are Python, nothing of Grus acts."""

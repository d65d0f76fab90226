"""Specimens of rockfill as constitutive descriptions, integrated step by step; no particles, nothing of Grus."""

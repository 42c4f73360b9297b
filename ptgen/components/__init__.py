"""Components: each file is one part of a test bed, written like a page of a textbook."""

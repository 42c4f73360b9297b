"""What people read: texts, figures and drawings of every stage."""

"""The abstract machine that the gl commands drive: state, matrices, packets.  It knows no GPU."""

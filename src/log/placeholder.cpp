namespace tread { int logPlaceholder(); int logPlaceholder() { return 0; } }

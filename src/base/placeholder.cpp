namespace tread { int placeholder(); int placeholder() { return 0; } }
